// What AppState does to the document: every change can be undone, together with the charts.

#include <utility>

#include "app/host/state/app_state.h"

namespace chartflood {

bool AppState::floodsLive(bool dragging) const {
  if (preferences.live == LiveMode::Off) return false;
  if (!dragging || preferences.live == LiveMode::On) return true;
  const double last = results_->timing.segment;
  return last >= 0 && last < kLiveMilliseconds;
}

bool AppState::answersDrags() const {
  if (!preferences.explore) return floodsLive(true);
  return !hasMesh() || results_->mesh->triangleCount() <= kMostSketched;
}

Session::Answer AppState::answerTo(bool dragging) const {
  using Answer = Session::Answer;
  if (!preferences.explore) return floodsLive(dragging) ? Answer::Flood : Answer::Nothing;
  if (!dragging) return Answer::Finished;
  return answersDrags() ? Answer::Sketch : Answer::Nothing;
}

/// Where the charts of the document come from; charts on the way come from the values alone.
FloodMoment AppState::presentMoment(const Results& results) const {
  FloodMoment moment = momentOf(results);
  const WorkStatus now = session_.status();
  if (!now.busy || now.unwrapping || !results.mesh) return moment;
  if (preferences.explore) return {};
  moment.taken = results.mesh->faceCount();  // a flood under way would have been finished
  return moment;
}

UndoStep AppState::present() const {
  return {session_.document(), presentMoment(*session_.results())};
}

/// Keeps the figures that the next charts are held against.
void AppState::noteFigures() {
  if (!preferences.explore) return earlierFigures_.reset();
  if (changing() || !results_->finished || !settled(*results_)) return;
  earlierFigures_ = liveFigures();
}

void AppState::changeDocument(const Document& document, std::string name, const std::string& key,
                              bool dragging) {
  const Document before = session_.document();
  const Document after = withFittingSeeds(before, document);
  if (dragging && after == before) return;  // the mouse rests
  if (after != before) {
    noteFigures();
    undo_.changed(present(), std::move(name), key);
  }
  if (!dragging) undo_.close();
  if (preferences.explore) {  // the picture never goes back to less than finished charts
    playback.follow();
    firstFlood_ = false;
  }
  session_.setDocument(after, answerTo(dragging));
}

void AppState::rememberCharts(std::string name) {
  noteFigures();
  undo_.changed(present(), std::move(name), "charts of a moment");
  undo_.close();
}

void AppState::finish() {
  playback.follow();
  firstFlood_ = false;
  if (!preferences.explore) return request(StepRequest{StepUnit::Converged, 1});
  session_.setDocument(document(), Session::Answer::Finished);
}

void AppState::takeUp(const Document& document, const FloodMoment& moment, std::string name) {
  rememberCharts(std::move(name));
  selectedChart = kNone;
  restore({document, moment});
}

void AppState::restore(const UndoStep& step) {
  playback.follow();
  hoveredSeed = kNone;
  session_.restore(step.document, step.moment, answerTo(false));
}

void AppState::undo() {
  if (!undo_.canUndo()) return;
  noteFigures();
  restore(undo_.undo(present()));
}

void AppState::redo() {
  if (!undo_.canRedo()) return;
  noteFigures();
  restore(undo_.redo(present()));
}

void AppState::takeBackDrag() {
  const std::optional<UndoStep> step = undo_.takeBack();
  if (step) session_.restore(step->document, step->moment, answerTo(false));
}

}  // namespace chartflood
