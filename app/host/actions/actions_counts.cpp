// Actions that find the number of charts instead of being told.

#include <algorithm>
#include <string>

#include "app/host/actions/actions.h"
#include "app/host/script/action_registry.h"
#include "app/host/state/app_state.h"
#include "app/host/state/run_watch.h"
#include "core/base/error.h"
#include "core/segment/creases/crease_regions.h"
#include "core/segment/registry.h"

namespace chartflood {

namespace {

std::string needsRest(const AppState& state) {
  if (!state.hasMesh()) return "There is no model yet; open one first.";
  return state.changing() ? "The charts are changing: wait until they rest, or press Esc." : "";
}

std::string needsRuns(const AppState& state) {
  return state.results().chartRuns ? needsRest(state)
                                   : "No numbers of charts were tried yet: choose Fewest charts.";
}

void countCreases(AppState& state) {
  const Results& now = state.results();
  const std::size_t count = creaseRegions(*now.mesh, *now.gaussArea).count;
  if (count < 2) throw Refusal("No creases divide this model: its charts are up to you.");
  Document document = state.document();
  askCharts(document.parameters, static_cast<int>(count));
  if (segmenterOf(document.parameters.method).knowsCreases) document.parameters.start = "creases";
  document.seeds.clear();
  state.playback.follow();
  state.changeDocument(document, "Charts from creases", "charts", false);
  if (!state.preferences.explore) state.finish();
}

void useCount(AppState& state, long charts) {
  const std::vector<Run>& runs = state.results().chartRuns->runs;
  const auto run = std::find_if(runs.begin(), runs.end(), [&](const Run& each) {
    return static_cast<long>(each.charts) == charts;
  });
  if (run == runs.end()) {
    throw UsageError(std::to_string(charts) + " charts were not tried; see the tab Plots.");
  }
  useChartRun(state, static_cast<std::size_t>(run - runs.begin()));
}

}  // namespace

void addCountActions(ActionRegistry& registry) {
  registry.add({.id = "charts-from-creases",
                .title = "Charts from creases",
                .help = "As many charts as the creases divide the model into, cut along these: for "
                        "machine parts.",
                .arguments = {},
                .refusal = needsRest,
                .run = [](AppState& state, const Arguments&) { countCreases(state); }});
  registry.add(
      {.id = "find-charts",
       .title = "Fewest charts",
       .help = "Tries few charts with the relief cuts they need, then more, and takes the shortest "
               "seams with which no chart stretches more than allowed. The tab Plots shows what "
               "was tried.",
       .arguments = {},
       .refusal = needsRest,
       .run = [](AppState& state, const Arguments&) { state.session().findChartCount(); }});
  registry.add(
      {.id = "use-count",
       .title = "Use a number of charts",
       .help = "Takes the charts of a number that was tried.",
       .arguments = {{"charts", ArgumentType::Integer, "how many"}},
       .refusal = needsRuns,
       .run = [](AppState& state, const Arguments& a) { useCount(state, a.integer("charts")); }});
}

}  // namespace chartflood
