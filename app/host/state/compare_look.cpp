#include "app/host/state/compare_look.h"

#include <cstdio>

#include "app/host/state/app_state.h"

namespace chartflood {

namespace {

std::string format(const char* pattern, double a, double b = 0) {
  char text[96];
  std::snprintf(text, sizeof text, pattern, a, b);
  return text;
}

CompareLook& lookOf(Compare& compare, ComparePane pane) {
  return pane.live() ? compare.liveLook : compare.stored[pane.stored].look;
}

bool isActive(const Compare& compare, ComparePane pane) { return compare.active == pane; }

}  // namespace

StoredResult storedNow(const AppState& state, const std::string& name) {
  StoredResult stored;
  stored.name = name;
  stored.results = state.sharedResults();
  stored.document = state.document();
  stored.figures = compareFigures(*stored.results);
  for (const PlacedSeed& seed : state.presentSeeds()) {
    const auto number = static_cast<Index>(stored.seeds.size());
    stored.seeds.push_back({seed.face, number, false, seed.locked});
  }
  stored.look = {state.view.camera, state.view.render};
  return stored;
}

void activate(AppState& state, ComparePane pane) {
  Compare& compare = state.compare;
  if (isActive(compare, pane)) return;
  const bool known = compare.active.live() || compare.active.stored < compare.stored.size();
  if (known) lookOf(compare, compare.active) = {state.view.camera, state.view.render};
  compare.active = pane;
  if (!compare.linkCameras) state.view.camera = lookOf(compare, pane).camera;
  if (!compare.linkColors) state.view.render = lookOf(compare, pane).render;
}

void shareLook(AppState& state) {
  const CompareLook look{state.view.camera, state.view.render};
  state.compare.liveLook = look;
  for (StoredResult& each : state.compare.stored) each.look = look;
}

const Results& paneResults(const AppState& state, ComparePane pane) {
  return pane.live() ? state.results() : *state.compare.stored[pane.stored].results;
}

Insight& paneInsight(const AppState& state, ComparePane pane) {
  if (pane.live()) return state.insight();
  const StoredResult& stored = state.compare.stored[pane.stored];
  if (Insight::sameProblems(*stored.results, state.results())) return state.insight();
  // In the state's own both would be worked out in turn, over and over.
  if (!stored.insight) stored.insight = state.insight().beside();
  return *stored.insight;
}

Camera paneCamera(const AppState& state, ComparePane pane) {
  const Compare& compare = state.compare;
  if (compare.linkCameras || isActive(compare, pane)) return state.view.camera;
  return pane.live() ? compare.liveLook.camera : compare.stored[pane.stored].look.camera;
}

RenderSettings paneLook(const AppState& state, ComparePane pane) {
  const Compare& compare = state.compare;
  const CompareLook& own = pane.live() ? compare.liveLook : compare.stored[pane.stored].look;
  RenderSettings settings =
      compare.linkColors || isActive(compare, pane) ? state.view.render : own.render;
  const RenderSettings& checker =
      compare.linkChecker || isActive(compare, pane) ? state.view.render : own.render;
  settings.checkerSquares = checker.checkerSquares;
  settings.checkerInTexture = checker.checkerInTexture;
  settings.checkerKind = checker.checkerKind;
  settings.checkerTint = checker.checkerTint;
  settings.checkerPicture = checker.checkerPicture;
  settings.checkerRepeats = checker.checkerRepeats;
  // A pointed-at face is the same on all sides of one model.
  const bool sameMesh = paneResults(state, pane).mesh == state.results().mesh;
  settings.hoverFace = sameMesh ? state.hoveredFace : kNone;
  const Index selected =
      pane.live() ? state.selectedChart : compare.stored[pane.stored].selectedChart;
  if (selected != kNone) settings.selectedCharts.push_back(selected);
  return settings;
}

PaneCaption paneCaption(const AppState& state, ComparePane pane) {
  const Compare& compare = state.compare;
  const Results& results = paneResults(state, pane);
  const CompareFigures figures =
      pane.live() ? state.liveFigures() : compare.stored[pane.stored].figures;
  PaneCaption caption;
  caption.method = figures.method;
  caption.figures.push_back("K " + std::to_string(figures.charts));
  if (figures.spread) caption.figures.push_back(format("spread %.1f %%", 100 * *figures.spread));
  if (figures.stretch) {
    caption.figures.push_back(
        format("stretch %.3f \u00b1%.3f", *figures.stretch, *figures.stretchStd));
  }
  if (figures.seams) caption.figures.push_back(format("seams %.2f \u221aarea", *figures.seams));
  if (paneLook(state, pane).problems) {
    const auto problems = paneInsight(state, pane).problems(results);
    for (const Problem& each : problems ? *problems : std::vector<Problem>{}) {
      caption.problems.push_back(problemText(each));
    }
    if (problems && problems->empty()) caption.problems.emplace_back("no problems");
  }
  for (const ComparePane& other : compare.panes()) {
    if (other == pane) continue;
    caption.differing =
        differingParameters(results.parameters, paneResults(state, other).parameters);
    if (!caption.differing.empty()) break;
  }
  return caption;
}

}  // namespace chartflood
