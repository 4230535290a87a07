#include "app/gui/views/uv_view.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include <epoxy/gl.h>

#include "app/gui/views/drawing_budget.h"
#include "app/gui/widgets/imgui_gl.h"

namespace chartflood {

RenderSettings uvSettings(const AppState& state, float pixelScale) {
  RenderSettings settings = sceneSettings(state, pixelScale);
  settings.hoverFace = kNone;  // drawn over the picture
  if (state.film.ready()) {    // the film is about the model alone
    settings.playhead.reset();
    settings.colorMode = state.view.render.colorMode;
  }
  settings.scalarBar = false;  // it stands beside the model
  settings.numbers = true;
  settings.textSize *= 0.9f;
  const glm::vec3 ground = 0.5f * (settings.background.bottom + settings.background.top);
  settings.background.bottom = settings.background.top = ground;
  return settings;
}

bool UvView::ready(const AppState& state) const {
  return state.results().charts && state.results().atlas;
}

void UvView::begin(const Shown& wanted) {
  const bool fits = back_.width() == wanted.width && back_.height() == wanted.height &&
                    backSamples_ == wanted.samples;
  if (!fits) back_ = gl::Framebuffer(wanted.width, wanted.height, wanted.samples);
  backSamples_ = wanted.samples;
  scene_.renderer().beginDrawingUv(back_, wanted.camera, wanted.settings, wanted.style,
                                   PicturePart::whole(wanted.width, wanted.height));
  pending_ = wanted;
  pendingSeconds_ = 0;
}

bool UvView::goOn() {
  if (!pending_) return false;
  if (!scene_.renderer().drawing(back_)) {  // the scene went first
    pending_.reset();
    return true;
  }
  const auto start = std::chrono::steady_clock::now();
  const bool ready = scene_.renderer().continueDrawing(kSecondsAtOnce);
  if (ready) glFinish();  // the cost decides on the smoothing of the next pictures
  pendingSeconds_ +=
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (!ready) return false;
  if (pending_->samples == kSmoothSamples) smoothSeconds_ = pendingSeconds_;
  lastSeconds_ = pendingSeconds_;
  glBindTexture(GL_TEXTURE_2D, back_.texture());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  std::swap(front_, back_);
  std::swap(frontSamples_, backSamples_);
  shown_ = std::exchange(pending_, std::nullopt);
  return true;
}

UvPicture UvView::picture(const AppState& state, int width, int height, float pixelScale,
                          UvMotion motion) {
  const gl::FramebufferScope keep;
  width_ = std::max(1, width);
  height_ = std::max(1, height);
  const bool slow = smoothSeconds_ > kSmoothWhileMoving;
  const Shown wanted{uvSettings(state, pixelScale),
                     state.view.uv,
                     state.view.uvCamera,
                     width_,
                     height_,
                     slow && motion == UvMotion::Own ? 1 : kSmoothSamples,
                     scene_.content()};
  if (pending_ && !scene_.renderer().drawing(back_)) pending_.reset();
  // Islands never take on the labels of charts that they were not made of.
  const bool old = !state.results().flat || !scene_.showsTextureOf(state);
  const bool leave = shown_ && (old || (slow && motion == UvMotion::Elsewhere));
  const bool free = !pending_ && !scene_.busy();
  if (free && !leave && (!shown_ || *shown_ != wanted)) {
    begin(wanted);
    // Quick drivers finish it at once; slow ones go on after the window was looked after.
    if (lastSeconds_ < kSecondsAtOnce) goOn();
  }
  if (!shown_) return {nullptr, wanted.camera, width_, height_};
  return {textureId(front_), shown_->camera, shown_->width, shown_->height};
}

Pick UvView::pick(const AppState& state, int x, int y) {
  const gl::FramebufferScope keep;
  return scene_.renderer().pickUv(state.view.uvCamera, width_, height_, x, y);
}

const UvHighlight& UvView::highlight(const AppState& state) {
  const Index face = state.hoveredFace;
  if (face == highlightFace_ && scene_.content() == highlightContent_) return highlight_;
  highlightFace_ = face;
  highlightContent_ = scene_.content();
  highlight_ = {};
  const std::shared_ptr<const UvLayout> layout = scene_.renderer().textureLayout();
  const Mesh* mesh = scene_.renderer().mesh();
  if (layout == nullptr || face >= mesh->faceCount()) return highlight_;
  const Index first = mesh->triangleBegin(face);
  const Index island = layout->island[first];
  if (island == kNone) return highlight_;
  for (Index c = 3 * first; c < 3 * mesh->triangleBegin(face + 1); ++c) {
    highlight_.face.emplace_back(layout->corners[c]);
  }
  const SegmentRange range = layout->outlineOf[island];
  for (std::size_t i = range.first; i < range.first + range.count; ++i) {
    const Index side = layout->outline[i];
    highlight_.outline.emplace_back(layout->corners[side]);
    highlight_.outline.emplace_back(layout->corners[Mesh::nextSide(side)]);
  }
  return highlight_;
}

}  // namespace chartflood
