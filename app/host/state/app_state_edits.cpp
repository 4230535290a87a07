// What AppState does to the document: every change can be undone, together with the charts.

#include <utility>

#include "app/host/state/app_state.h"

namespace chartflood {

UndoStep AppState::present() const {
  const std::shared_ptr<const Results> results = session_.results();
  UndoStep step{session_.document(), momentOf(*results)};
  // A flood under way would have been finished.
  if (changing() && results->mesh) step.moment.taken = results->mesh->faceCount();
  return step;
}

void AppState::changeDocument(const Document& document, std::string name, const std::string& key,
                              bool dragging) {
  const Document before = session_.document();
  const Document after = withFittingSeeds(before, document);
  if (after != before) undo_.changed(present(), std::move(name), key);
  if (!dragging) undo_.close();
  session_.setDocument(after,
                       floodsLive(dragging) ? Session::Answer::Flood : Session::Answer::Nothing);
}

void AppState::rememberCharts(std::string name) {
  undo_.changed(present(), std::move(name), "charts of a moment");
  undo_.close();
}

bool AppState::floodsLive(bool dragging) const {
  if (preferences.live == LiveMode::Off) return false;
  if (!dragging || preferences.live == LiveMode::On) return true;
  const double last = results_->timing.segment;
  return last >= 0 && last < kLiveMilliseconds;
}

void AppState::takeUp(const Document& document, const FloodMoment& moment, std::string name) {
  rememberCharts(std::move(name));
  playback.follow();
  selectedChart = hoveredSeed = kNone;
  session_.restore(document, moment);
}

void AppState::undo() {
  if (!undo_.canUndo()) return;
  playback.follow();
  hoveredSeed = kNone;
  const UndoStep step = undo_.undo(present());
  session_.restore(step.document, step.moment);
}

void AppState::redo() {
  if (!undo_.canRedo()) return;
  playback.follow();
  hoveredSeed = kNone;
  const UndoStep step = undo_.redo(present());
  session_.restore(step.document, step.moment);
}

void AppState::takeBackDrag() {
  const std::optional<UndoStep> step = undo_.takeBack();
  if (step) session_.restore(step->document, step->moment);
}

}  // namespace chartflood
