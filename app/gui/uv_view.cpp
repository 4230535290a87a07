#include "app/gui/uv_view.h"

#include <algorithm>
#include <chrono>

#include <epoxy/gl.h>

#include "app/gui/imgui_gl.h"

namespace chartflood {

namespace {

constexpr int kSmoothSamples = 4;
constexpr double kQuick = 0.012;  // seconds; slower pictures wait while something else moves
constexpr double kSlow = 0.060;   // slower ones do without the face under the mouse

}  // namespace

RenderSettings uvSettings(const AppState& state, float pixelScale) {
  RenderSettings settings = sceneSettings(state, pixelScale);
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

void UvView::draw(const Shown& wanted) {
  const auto start = std::chrono::steady_clock::now();
  const bool fits = shown_ && shown_->width == wanted.width && shown_->height == wanted.height &&
                    shown_->samples == wanted.samples;
  if (!fits) target_ = gl::Framebuffer(wanted.width, wanted.height, wanted.samples);
  scene_.renderer().drawUv(target_, wanted.camera, wanted.settings, wanted.style);
  glFinish();  // the cost decides on the next pictures
  seconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  glBindTexture(GL_TEXTURE_2D, target_.texture());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  shown_ = wanted;
}

ImTextureID UvView::picture(const AppState& state, int width, int height, float pixelScale,
                            bool elsewhere) {
  const gl::FramebufferScope keep;
  Shown wanted{
      uvSettings(state, pixelScale), state.view.uv,  state.view.uvCamera, std::max(1, width),
      std::max(1, height),           kSmoothSamples, scene_.content()};
  if (seconds_ > kSlow) wanted.settings.hoverFace = kNone;
  const bool sameSize = shown_ && shown_->width == wanted.width && shown_->height == wanted.height;
  const bool wait = sameSize && seconds_ > kQuick && (elsewhere || scene_.busy()) &&
                    shown_->camera == wanted.camera;
  if (!wait && (!shown_ || *shown_ != wanted)) draw(wanted);
  return textureId(target_.texture());
}

Pick UvView::pick(int x, int y) {
  if (!shown_) return {};
  const gl::FramebufferScope keep;
  return scene_.renderer().pickUv(shown_->camera, shown_->width, shown_->height, x, y);
}

}  // namespace chartflood
