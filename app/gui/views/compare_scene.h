#pragma once
/// The pictures of a comparison: the live view and one more for each stored result, made when it is
/// first shown and given back when the comparison ends.

#include <functional>
#include <memory>
#include <vector>

#include "app/gui/views/scene_view.h"

namespace chartflood {

class CompareScene : public SceneSource {
 public:
  /// `live` stays where it is and is shared with the texture's view.
  CompareScene(SceneView& live, std::function<void()> wake) : live_(live), wake_(std::move(wake)) {}

  ImTextureID picture(const AppState& state, int width, int height, float pixelScale,
                      bool moving) override;
  Pick pick(int x, int y) override { return live_.pick(x, y); }
  std::vector<glm::vec3> chartColors(const AppState& state) const override {
    return live_.chartColors(state);
  }
  std::vector<Index> chartColorNumbers(const AppState& state) const override {
    return live_.chartColorNumbers(state);
  }
  SceneSource* side(const AppState& state, ComparePane pane) override;

  /// The view of a half, up to date, with the scale that all share. Needs a current GL context.
  SceneView& view(const AppState& state, ComparePane pane);
  SceneView& live() { return live_; }

  /// As in SceneView, for all halves.
  void catchUp(const AppState& state);
  bool busy() const;
  bool goOn();

 private:
  struct Side {
    std::shared_ptr<const Segmentation> of;  ///< whose charts it shows
    std::unique_ptr<SceneView> view;
  };

  void update(const AppState& state);
  SceneView& viewOf(ComparePane pane) { return pane.live() ? live_ : *sides_[pane.stored].view; }

  SceneView& live_;
  std::function<void()> wake_;
  std::vector<Side> sides_;  ///< by the number of the stored result; views of hidden ones are null
};

}  // namespace chartflood
