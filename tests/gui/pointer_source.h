#pragma once
/// A 3D view without GL: draws nothing and finds what is under the mouse by a ray through all
/// triangles.

#include "app/gui/views/scene_view.h"

namespace chartflood {

class PointerSource : public SceneSource {
 public:
  ImTextureID picture(const AppState& state, int width, int height, float, bool) override {
    state_ = &state;
    width_ = width;
    height_ = height;
    return nullptr;
  }
  Pick pick(int x, int y) override;

 private:
  const AppState* state_ = nullptr;  ///< of the last picture
  int width_ = 1, height_ = 1;
};

}  // namespace chartflood
