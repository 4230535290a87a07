#include "app/gui/views/picture_pieces.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/gui/views/uv_view.h"
#include "render/passes/offscreen_render.h"

namespace chartflood {

namespace {

/// All halves side by side, or the first two left and right of the wipe's line.
std::vector<PicturePiece> sidePieces(const AppState& state, CompareScene& scene,
                                     const PictureRequest& request, int width, int height,
                                     float lineScale) {
  const std::vector<ComparePane> panes = state.compare.panes();
  const bool wipe = state.compare.layout == Compare::Layout::Wipe;
  const int line = static_cast<int>(std::lround(state.compare.wipe * width));
  const auto count = static_cast<int>(panes.size());
  std::vector<PicturePiece> pieces;
  for (int i = 0; i < count; ++i) {
    const ComparePane pane = panes[static_cast<std::size_t>(i)];
    SceneView& view = scene.view(state, pane);
    PicturePiece piece;
    piece.renderer = &view.renderer();
    piece.content = view.content();
    piece.camera = paneCamera(state, pane);
    piece.look = pictureLook(request, view.settings(state, lineScale));
    piece.height = height;
    if (wipe) {
      piece.width = width;
      piece.from = i == 0 ? 0 : line;
      piece.to = i == 0 ? line : width;
    } else {
      piece.left = width * i / count;
      piece.width = piece.to = width * (i + 1) / count - piece.left;
    }
    pieces.push_back(std::move(piece));
  }
  return pieces;
}

Image drawPiece(const PicturePiece& piece, int smooth) {
  const PictureSize size{.width = piece.width, .height = piece.height, .supersampling = smooth};
  return piece.texture
             ? renderUvImage(*piece.renderer, piece.uvCamera, piece.look, piece.style, size)
             : renderImage(*piece.renderer, piece.camera, piece.look, size);
}

}  // namespace

RenderSettings pictureLook(const PictureRequest& request, RenderSettings settings) {
  settings.hoverFace = settings.hoverChart = settings.flashFace = kNone;
  if (request.bare) settings.selectedCharts.clear();
  applyPicture(request.settings, settings);
  return settings;
}

PictureExtent wantedExtent(const AppState& state, const PictureSettings& settings) {
  const PanelState& panels = state.panels;
  if (settings.view == "window") return {panels.windowWidth, panels.windowHeight, 1};
  return pictureExtent(settings, panels.viewWidth, panels.viewHeight);
}

std::vector<PicturePiece> picturePieces(const AppState& state, CompareScene& scene,
                                        const PictureRequest& request, int width, int height,
                                        float lineScale) {
  const std::string& view = request.settings.view;
  if (view == "ab" && state.compare.showing()) {
    return sidePieces(state, scene, request, width, height, lineScale);
  }
  SceneView& live = scene.live();
  live.prepare(state);
  PicturePiece model;
  model.renderer = &live.renderer();
  model.content = live.content();
  model.camera = state.view.camera;
  model.uvCamera = state.view.uvCamera;
  model.style = state.view.uv;
  model.look = pictureLook(request, sceneSettings(state, lineScale));
  model.width = model.to = width;
  model.height = height;
  const bool flat = model.renderer->hasUv();
  if (!flat || (view != "uv" && view != "both")) return {model};
  PicturePiece texture = model;
  texture.texture = true;
  if (view == "uv") {
    texture.look = pictureLook(request, uvSettings(state, lineScale));
    texture.look.textSize = model.look.textSize;  // letters are as large in all pictures
    return {texture};
  }
  const BothWidths widths = widthsOfBoth({.width = width, .height = height});
  model.width = model.to = widths.scene;
  if (widths.scene + widths.uv > width) return {model};  // one pixel wide
  texture.look.scalarBar = false;                        // stands with the model
  texture.left = widths.scene;
  texture.width = texture.to = widths.uv;
  return {model, texture};
}

Image drawPieces(std::span<const PicturePiece> pieces, int width, int height, int smooth) {
  Image image(width, height);
  for (const PicturePiece& piece : pieces) {
    const Image drawn = drawPiece(piece, smooth);
    for (int y = 0; y < piece.height; ++y) {
      std::copy_n(&drawn.at(0, y) + piece.from, piece.to - piece.from,
                  &image.at(0, y) + piece.left + piece.from);
    }
  }
  return image;
}

}  // namespace chartflood
