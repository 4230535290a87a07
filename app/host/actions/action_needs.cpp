#include "app/host/actions/action_needs.h"

#include "app/host/state/app_state.h"

namespace chartflood {

std::string needsMesh(const AppState& state) {
  return state.hasMesh() ? "" : "There is no model yet; open one first.";
}

std::string needsCharts(const AppState& state) {
  const auto& stats = state.results().chartStats;
  return stats && !stats->charts.empty() ? "" : "There are no charts yet.";
}

std::string needsSeeds(const AppState& state) {
  if (!state.hasMesh()) return needsMesh(state);
  return state.presentSeeds().empty() ? "There are no seeds yet; press Play." : "";
}

std::string pictureRefusal(const AppState& state, const std::string& view) {
  if (view == "ab" && !state.compare.showing()) {
    return "Nothing is compared: store the present charts as A first (Compare).";
  }
  const bool flat = state.results().charts && state.results().atlas;
  if ((view == "uv" || view == "both") && !flat) {
    return "The charts are not laid flat yet; press Unwrap (W) first.";
  }
  return "";
}

Index namedChart(const AppState& state, const Arguments& arguments) {
  const long wanted = arguments.integer("chart", -1);
  const Index chart = wanted < 0 ? state.selectedChart : static_cast<Index>(wanted);
  if (chart == kNone) throw Refusal("Select a chart first.");
  if (!needsCharts(state).empty() || chart >= state.results().chartStats->charts.size()) {
    throw Refusal("There is no chart " + std::to_string(chart) + '.');
  }
  return chart;
}

}  // namespace chartflood
