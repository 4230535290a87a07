#include "render/gl/offscreen_context.h"

#include <string>

#include "core/base/error.h"

namespace chartflood::gl {

OffscreenBackend offscreenBackendFromId(std::string_view id) {
  if (id == "auto") return OffscreenBackend::Auto;
  if (id == "osmesa") return OffscreenBackend::OSMesa;
  if (id == "egl") return OffscreenBackend::Egl;
  throw UsageError("There is no rendering backend \"" + std::string(id) +
                   "\"; choose auto, osmesa or egl.");
}

std::unique_ptr<Context> createOffscreenContext(OffscreenBackend backend) {
  if (backend == OffscreenBackend::OSMesa) return createOsmesaContext();
  if (backend == OffscreenBackend::Egl) return createEglContext();
  std::string osmesaCause;
  try {
    return createOsmesaContext();
  } catch (const Error& error) {
    osmesaCause = error.what();
  }
  try {
    return createEglContext();
  } catch (const Error& error) {
    throw Error("No way to draw without a window was found. " + osmesaCause + " " + error.what());
  }
}

}  // namespace chartflood::gl
