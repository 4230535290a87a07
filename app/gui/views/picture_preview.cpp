#include "app/gui/views/picture_preview.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include <epoxy/gl.h>

#include "app/gui/views/drawing_budget.h"
#include "app/gui/widgets/imgui_gl.h"
#include "core/base/stopwatch.h"
#include "render/passes/offscreen_render.h"

namespace chartflood {

namespace {

/// So many times what the last one took must pass before another is begun: while things move the
/// preview takes a small share of the time. Seconds are the most.
constexpr double kRest = 4, kLongestRest = 0.25;
/// The window is drawn larger than it is shown: thin lines and letters stay.
constexpr int kFiner = 2;

void drawWindow(ImguiGl& drawer, const ImDrawData& data, const gl::Framebuffer& target) {
  const gl::FramebufferScope keep;
  target.bindForDrawing();
  glDisable(GL_SCISSOR_TEST);
  glClearColor(0, 0, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  ImDrawData scaled = data;
  scaled.FramebufferScale = {static_cast<float>(target.width()) / data.DisplaySize.x,
                             static_cast<float>(target.height()) / data.DisplaySize.y};
  drawer.draw(scaled, belongsToPictureDialog);
  target.resolve();
}

}  // namespace

bool belongsToPictureDialog(const ImDrawList& list) {
  const std::string_view owner = list._OwnerName == nullptr ? "" : list._OwnerName;
  // Lists and hints that stand open while the mouse is in the dialog are its own.
  return owner == kPictureDialog || owner.starts_with("##Combo") || owner.starts_with("##Tooltip");
}

Image windowImage(ImguiGl& drawer, const ImDrawData& data) {
  const auto pixels = [](float size, float scale) {
    return std::max(1, static_cast<int>(size * scale));
  };
  const gl::Framebuffer target(pixels(data.DisplaySize.x, data.FramebufferScale.x),
                               pixels(data.DisplaySize.y, data.FramebufferScale.y), 1);
  drawWindow(drawer, data, target);
  return readFramebuffer(target);
}

void PicturePreview::takeWindow(ImguiGl& drawer, const ImDrawData& data) {
  if (windowWidth_ < 1 || data.DisplaySize.x < 1 || data.DisplaySize.y < 1) return;
  const int width = kFiner * windowWidth_, height = kFiner * windowHeight_;
  if (window_.width() != width || window_.height() != height) {
    window_ = gl::Framebuffer(width, height, 1);
  }
  drawWindow(drawer, data, window_);
}

void PicturePreview::begin(std::size_t slot, const PicturePiece& piece) {
  gl::Framebuffer& back = slots_[slot].back;
  if (back.width() != piece.width || back.height() != piece.height) {
    back = gl::Framebuffer(piece.width, piece.height, kSmoothSamples);
  }
  const PicturePart whole = PicturePart::whole(piece.width, piece.height);
  if (piece.texture) {
    piece.renderer->beginDrawingUv(back, piece.uvCamera, piece.look, piece.style, whole);
  } else {
    piece.renderer->beginDrawing(back, piece.camera, piece.look, whole);
  }
  pending_ = slot;
  pendingPiece_ = piece;
  pendingSeconds_ = 0;
}

bool PicturePreview::goOn() {
  if (!pending_) return false;
  Slot& slot = slots_[*pending_];
  if (!pendingPiece_.renderer->drawing(slot.back)) {  // a view went first
    pending_.reset();
    return true;
  }
  const auto start = std::chrono::steady_clock::now();
  const bool ready = pendingPiece_.renderer->continueDrawing(kSecondsAtOnce);
  pendingSeconds_ += secondsSince(start);
  if (!ready) return false;
  lastSeconds_ = pendingSeconds_;
  readyAt_ = std::chrono::steady_clock::now();
  std::swap(slot.front, slot.back);
  slot.shown = std::move(pendingPiece_);
  pending_.reset();
  return true;
}

bool PicturePreview::resting() const {
  return secondsSince(readyAt_) < std::min(kLongestRest, kRest * lastSeconds_);
}

std::vector<PreviewPart> PicturePreview::preview(const AppState& state, const PictureExtent& extent,
                                                 int width, int height, float pixelScale) {
  const gl::FramebufferScope keep;
  windowWidth_ = windowHeight_ = 0;
  if (state.preferences.picture.view == "window") {
    pending_.reset();
    upToDate_ = true;  // every pass takes it in
    windowWidth_ = width;
    windowHeight_ = height;
    if (window_.width() == 0) return {};
    return {{textureId(window_), 0, 1, 0, 1}};
  }
  PictureRequest request;
  request.settings = state.preferences.picture;
  const float smaller = static_cast<float>(width) / static_cast<float>(extent.width);
  const std::vector<PicturePiece> pieces =
      picturePieces(state, scene_, request, width, height, pixelScale * extent.scale * smaller);
  // One that is not wanted any more, or that a view has pushed aside.
  if (pending_ && (*pending_ >= pieces.size() || pendingPiece_ != pieces[*pending_] ||
                   !pendingPiece_.renderer->drawing(slots_[*pending_].back))) {
    pending_.reset();
  }
  std::vector<PreviewPart> parts;
  upToDate_ = true;
  for (std::size_t i = 0; i < std::min(pieces.size(), slots_.size()); ++i) {
    Slot& slot = slots_[i];
    const PicturePiece& piece = pieces[i];
    if (slot.shown != piece) {
      upToDate_ = false;
      if (!pending_ && !scene_.busy() && !uv_.busy() && !(slot.shown && resting())) {
        begin(i, piece);
        if (lastSeconds_ < kSecondsAtOnce) goOn();
      }
    }
    if (!slot.shown) continue;
    const auto share = [](int columns, int of) {
      return static_cast<float>(columns) / static_cast<float>(of);
    };
    parts.push_back({textureId(slot.front), share(piece.left + piece.from, width),
                     share(piece.left + piece.to, width), share(piece.from, piece.width),
                     share(piece.to, piece.width)});
  }
  return parts;
}

}  // namespace chartflood
