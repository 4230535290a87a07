#pragma once
/// What a picture of the views is put together from. The dialog's preview draws the same pieces as
/// the picture itself, only smaller.

#include <cstdint>
#include <span>
#include <vector>

#include "app/gui/views/compare_scene.h"
#include "app/host/state/app_state.h"
#include "render/passes/renderer.h"
#include "render/scene/image.h"

namespace chartflood {

/// One drawing, and the columns of the picture that show it.
struct PicturePiece {
  Renderer* renderer = nullptr;
  bool texture = false;  ///< charts laid flat, else the model
  Camera camera;
  UvCamera uvCamera;
  RenderSettings look;
  UvStyle style;
  int width = 1, height = 1;  ///< of the drawing, pixels
  int left = 0;               ///< where its first column stands in the picture
  int from = 0, to = 1;       ///< columns of the drawing that are shown
  std::uint64_t content = 0;  ///< of what the renderer knows

  bool operator==(const PicturePiece&) const = default;
};

/// The size of a picture as set, for the views or the window as they are.
PictureExtent wantedExtent(const AppState& state, const PictureSettings& settings);

/// The pieces of a picture of a view, from left to right. Without charts laid flat, or nothing to
/// compare, the model. `lineScale` is of lines and letters. Needs a current GL context; what is new
/// in the state is taken in.
std::vector<PicturePiece> picturePieces(const AppState& state, CompareScene& scene,
                                        const PictureRequest& request, int width, int height,
                                        float lineScale);

/// Draws them, with so many samples a pixel in each direction.
Image drawPieces(std::span<const PicturePiece> pieces, int width, int height, int smooth);

/// The settings of a picture of one view: nothing that the mouse points at.
RenderSettings pictureLook(const PictureRequest& request, RenderSettings settings);

}  // namespace chartflood
