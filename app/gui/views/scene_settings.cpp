// What the state wants the 3D view to show, as settings and marks.

#include "app/gui/views/scene_view.h"

namespace chartflood {

RenderSettings sceneSettings(const AppState& state, float pixelScale) {
  RenderSettings settings = state.view.render;
  settings.background = shownGround(settings.background, state.preferences.theme);
  settings.pixelScale = pixelScale;
  settings.playhead.reset();
  if (!state.showsFinal() && !state.playback.inBorders()) {
    settings.playhead = state.playback.playhead();
    settings.front = !(state.playback.complete() && state.playback.atEnd());
  }
  if (state.playback.inBorders()) settings.cuts = false;  // they are of the finished charts
  settings.hoverFace = state.hoveredFace;
  settings.flashFace = state.flash.face();
  settings.hoverChart = state.pointedChart;
  settings.selectedCharts.clear();
  if (state.film.ready()) {
    settings.colorMode = ColorMode::Charts;
    settings.problems = false;
    settings.playhead = state.film.position();
    settings.front = true;
    return settings;
  }
  if (settings.playhead) settings.problems = false;  // they belong to the finished charts
  if (state.selectedChart != kNone) settings.selectedCharts.push_back(state.selectedChart);
  if (state.view.isolate && state.selectedChart != kNone && state.results().segmentation) {
    const std::size_t count = state.results().segmentation->chartCount;
    for (Index chart = 0; chart < count; ++chart) {
      if (chart != state.selectedChart) settings.hiddenCharts.push_back(chart);
    }
  } else {
    settings.hiddenCharts = state.view.hiddenCharts;
  }
  return settings;
}

std::vector<SeedMark> seedMarks(const AppState& state) {
  std::vector<SeedMark> marks;
  const Playback& playback = state.playback;
  const auto& history = state.results().history;
  const bool editing = state.panels.tool == PanelState::Tool::Seeds;
  if (!editing && playback.round() != state.results().recordIteration &&
      playback.round() < history.size()) {
    for (const Index face : history[playback.round()].seeds) {
      const auto chart = static_cast<Index>(marks.size());
      marks.push_back({face, chart, false, false, state.closedOff(chart)});
    }
    return marks;
  }
  for (const PlacedSeed& seed : state.presentSeeds()) {
    const auto number = static_cast<Index>(marks.size());
    const bool emphasis = number == state.hoveredSeed || number == state.chosenSeed;
    marks.push_back({seed.face, number, emphasis, seed.locked, state.closedOff(number)});
  }
  if (const auto& drag = state.seedDrag; drag && drag->seed < marks.size()) {
    marks[drag->seed].face = drag->face;
    marks[drag->seed].emphasis = true;
  }
  return marks;
}

}  // namespace chartflood
