#include "core/session/pipeline/compared_methods.h"

#include "core/segment/registry.h"

namespace chartflood {

Parameters comparedWith(Parameters parameters, const std::string& method) {
  parameters.method = method;
  return parameters;
}

Parameters asLeft(Parameters parameters, const std::string& method) {
  parameters.method = method;
  if (!segmenterOf(method).refinesByDefault) parameters.refine = "none";
  return parameters;
}

}  // namespace chartflood
