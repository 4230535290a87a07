#include "app/host/state/run_watch.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "app/host/state/app_state.h"

namespace chartflood {

namespace {

/// Keeps the best of the seeds that were not chosen in the slots that are free.
void keepOthers(AppState& state, const RunSet& set) {
  std::vector<std::size_t> others;
  for (std::size_t i = 0; i < set.runs.size(); ++i) {
    if (i != set.chosen && set.runs[i].results) others.push_back(i);
  }
  std::stable_sort(others.begin(), others.end(), [&](std::size_t a, std::size_t b) {
    return set.runs[a].seams < set.runs[b].seams;
  });
  std::string names;
  for (const std::string slot : {"A", "B", "C"}) {
    if (others.empty() || state.compare.find(slot) != nullptr) continue;
    const Run& run = set.runs[others.front()];
    others.erase(others.begin());
    StoredResult stored;
    stored.name = slot;
    stored.document = state.document();
    stored.document.parameters = run.parameters;
    stored.document.parameters.bestOf = 1;
    stored.results = run.results;
    stored.figures = compareFigures(*run.results);
    stored.figures.seams = run.seams;
    for (const Index face : run.moment.start.seeds) {
      stored.seeds.push_back({face, static_cast<Index>(stored.seeds.size()), false, false});
    }
    stored.look = {state.view.camera, state.view.render};
    state.compare.store(std::move(stored));
    names += (names.empty() ? "" : ", ") + slot;
  }
  if (names.empty()) return;
  state.notices.add(Notice::Kind::Info, "The next best seeds are kept as " + names + '.');
}

}  // namespace

void RunWatch::update(AppState& state) {
  const Results& now = state.results();
  if (now.seedRuns != seedRuns) {
    seedRuns = now.seedRuns;
    if (seedRuns) keepOthers(state, *seedRuns);
  }
  if (now.chartRuns != chartRuns) {
    chartRuns = now.chartRuns;
    if (chartRuns) useChartRun(state, chartRuns->chosen);
  }
}

void useChartRun(AppState& state, std::size_t run) {
  const Run& tried = state.results().chartRuns->runs[run];
  Document document = state.document();
  // A model in parts has more charts than were asked for.
  askCharts(document.parameters, tried.parameters.charts);
  document.parameters.reliefStretch = tried.parameters.reliefStretch;
  const std::string name = std::to_string(tried.charts) + " charts";
  Stage stage = Stage::Layout;
  Parameters asTried = tried.parameters;
  asTried.chartsAsked = true;
  const bool differs = firstDifference(asTried, document.parameters, stage);
  if (differs && stage <= Stage::Refine) {
    state.playback.follow();
    state.changeDocument(document, name, "charts", false);
    if (!state.preferences.explore) state.finish();
  } else {
    state.takeUp(document, tried.moment, name);
  }
}

}  // namespace chartflood
