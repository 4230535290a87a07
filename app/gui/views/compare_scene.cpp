#include "app/gui/views/compare_scene.h"

#include <algorithm>
#include <utility>

namespace chartflood {

ImTextureID CompareScene::picture(const AppState& state, int width, int height, float pixelScale,
                                  bool moving) {
  sides_.clear();
  live_.setSharedRange(std::nullopt);
  return live_.picture(state, width, height, pixelScale, moving);
}

/// One view for each stored result that is shown. One that has drawn the same charts before, under
/// another letter, is used again.
void CompareScene::update(const AppState& state) {
  const std::vector<StoredResult>& stored = state.compare.stored;
  std::vector<Side> before = std::exchange(sides_, {});
  sides_.resize(stored.size());
  for (const ComparePane& pane : state.compare.panes()) {
    if (pane.live()) continue;
    Side& side = sides_[pane.stored];
    side.of = stored[pane.stored].results->segmentation;
    const auto known = std::find_if(before.begin(), before.end(), [&](const Side& each) {
      return each.view && each.of == side.of;
    });
    side.view = known != before.end() ? std::move(known->view) : std::make_unique<SceneView>(wake_);
    side.view->setPane(pane);
  }
}

SceneView& CompareScene::view(const AppState& state, ComparePane pane) {
  const std::vector<ComparePane> panes = state.compare.panes();
  if (panes.empty() || pane == panes.front()) {
    // The first one looks after all: each shares the scale of the others.
    update(state);
    std::vector<std::optional<ScalarRange>> ranges;
    for (const ComparePane& each : panes) {
      viewOf(each).prepare(state);
      if (state.compare.linkRange) ranges.push_back(viewOf(each).ownRange(state));
    }
    const auto common = commonRange(ranges);
    for (const ComparePane& each : panes) viewOf(each).setSharedRange(common);
  }
  return viewOf(pane);
}

SceneSource* CompareScene::side(const AppState& state, ComparePane pane) {
  return &view(state, pane);
}

void CompareScene::catchUp(const AppState& state) {
  if (!state.compare.showing()) return live_.catchUp(state);
  update(state);
  for (const ComparePane& each : state.compare.panes()) viewOf(each).catchUp(state);
}

bool CompareScene::busy() const {
  return live_.busy() || std::any_of(sides_.begin(), sides_.end(), [](const Side& side) {
           return side.view && side.view->busy();
         });
}

bool CompareScene::goOn() {
  if (live_.busy()) return live_.goOn();
  for (const Side& side : sides_) {
    if (side.view && side.view->busy()) return side.view->goOn();
  }
  return false;
}

}  // namespace chartflood
