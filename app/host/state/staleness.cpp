#include "app/host/state/staleness.h"

#include <algorithm>

#include "app/host/state/app_state.h"

namespace chartflood {

namespace {

/// The last stage that a section's parameters act on; what is read on request acts on none.
Stage lastStage(std::string_view group) {
  Stage last = Stage::Gauss;
  for (const ParameterInfo& info : parameterTable()) {
    if (group == info.group && info.stage != Stage::Request) last = std::max(last, info.stage);
  }
  return last;
}

}  // namespace

std::string_view bringsUpToDate(const AppState& state, std::string_view group) {
  const Results& results = state.results();
  if (!results.segmentation || state.changing()) return "";
  const Stage last = lastStage(group);
  Stage first{};
  const bool changed =
      firstDifference(results.parameters, state.document().parameters, first) && first <= last;
  if (last >= Stage::Cut) {
    const bool old = (results.charts || results.atlas) && (!results.flat || changed);
    return old && !state.status().unwrapping ? "unwrap" : "";
  }
  return results.stale || changed ? "run" : "";
}

}  // namespace chartflood
