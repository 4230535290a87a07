#include "app/gui/views/scene_view.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include <epoxy/gl.h>

#include "app/gui/views/drawing_budget.h"
#include "app/gui/widgets/imgui_gl.h"
#include "core/base/stopwatch.h"

namespace chartflood {

namespace {

constexpr double kSlow = 0.045;       // pictures of the whole surface that want a simple one
constexpr double kSimpleDetail = 12;  // pixels that the simple surface may leave out

/// Slower plain pictures get half the size in motion, quicker ones of half the size the full one.
struct CoarseLimits {
  double from, until;  ///< seconds
};
constexpr CoarseLimits coarseLimits(SurfaceForm form) {
  // Pixels are not what the simple surface takes long for.
  return form == SurfaceForm::Simple ? CoarseLimits{0.12, 0.06} : CoarseLimits{kSlow, 0.012};
}

}  // namespace

SceneView::SceneView(std::function<void()> wake) : wake_(std::move(wake)) {}

void SceneView::prepare(const AppState& state) {
  const gl::FramebufferScope keep;
  // A picture under way shows the data that it was begun with, and is finished even when a newer
  // one is wanted: while things move none would ever be otherwise. Only another mesh ends it.
  if (!pending_ || paneResults(state, pane_).mesh != mesh_) takeIn(state);
}

RenderSettings SceneView::settings(const AppState& state, float pixelScale) const {
  if (!state.compare.showing()) return sceneSettings(state, pixelScale);
  RenderSettings settings = paneLook(state, pane_);
  settings.background = shownGround(settings.background, state.preferences.theme);
  settings.pixelScale = pixelScale;
  settings.playhead.reset();
  if (pane_.live()) {
    const RenderSettings live = sceneSettings(state, pixelScale);
    settings.playhead = live.playhead;
    settings.front = live.front;
    settings.flashFace = live.flashFace;
    settings.hiddenCharts = live.hiddenCharts;
    settings.hoverChart = live.hoverChart;
    if (state.film.ready()) settings.colorMode = live.colorMode;
    // They belong to the finished charts.
    if (settings.playhead || state.film.ready()) settings.problems = false;
  }
  if (sharedRange_ && !settings.range) settings.range = sharedRange_;
  return settings;
}

std::optional<ScalarRange> SceneView::ownRange(const AppState& state) const {
  if (!mesh_) return std::nullopt;
  return renderer_.scalarRange(paneLook(state, pane_));
}

int SceneView::samplesFor(bool moving) const {
  return moving && smoothSeconds_ > kSmoothWhileMoving ? 1 : kSmoothSamples;
}

Camera SceneView::shownCamera(const AppState& state) const {
  return state.compare.showing() ? paneCamera(state, pane_) : state.view.camera;
}

SurfaceForm SceneView::formFor(const AppState& state, int samples) const {
  const double detail =
      renderer_.simpleDetail(shownCamera(state), PicturePart::whole(width_, height_));
  const bool fine = detail > 0 && detail < kSimpleDetail;
  return samples == 1 && slow_ && fine ? SurfaceForm::Simple : SurfaceForm::Whole;
}

void SceneView::begin(const Shown& wanted) {
  const bool fits = back_.width() == wanted.width && back_.height() == wanted.height &&
                    backSamples_ == wanted.samples;
  if (!fits) back_ = gl::Framebuffer(wanted.width, wanted.height, wanted.samples);
  backSamples_ = wanted.samples;
  renderer_.beginDrawing(back_, wanted.camera, wanted.settings,
                         PicturePart::whole(wanted.width, wanted.height), wanted.form);
  pending_ = wanted;
  pendingSeconds_ = 0;
}

bool SceneView::goOn() {
  if (!pending_) return false;
  const auto start = std::chrono::steady_clock::now();
  const bool ready = renderer_.continueDrawing(kSecondsAtOnce);
  if (ready) glFinish();  // the cost decides on the smoothing of the next pictures
  pendingSeconds_ += secondsSince(start);
  if (!ready) return false;
  if (pending_->samples == kSmoothSamples) {
    smoothSeconds_ = pendingSeconds_;
  } else {
    bool& coarse = this->coarse(pending_->form);
    const CoarseLimits limits = coarseLimits(pending_->form);
    coarse = pendingSeconds_ > (coarse ? limits.until : limits.from);
  }
  if (pending_->form == SurfaceForm::Whole && pendingSeconds_ > kSlow) slow_ = true;
  lastSeconds_ = pendingSeconds_;
  // Only a picture of half the size is enlarged; pixel by pixel the nearest texel is exact and
  // cheap.
  const bool enlarged = pending_->width < width_;
  glBindTexture(GL_TEXTURE_2D, back_.texture());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, enlarged ? GL_LINEAR : GL_NEAREST);
  std::swap(front_, back_);
  std::swap(frontSamples_, backSamples_);
  shown_ = std::exchange(pending_, std::nullopt);
  return true;
}

ImTextureID SceneView::picture(const AppState& state, int width, int height, float pixelScale,
                               bool moving) {
  const gl::FramebufferScope keep;
  prepare(state);
  if (pending_ && !renderer_.drawing(back_)) pending_.reset();
  width_ = std::max(1, width);
  height_ = std::max(1, height);
  const int samples = samplesFor(moving);
  const SurfaceForm form = formFor(state, samples);
  const int divisor = coarse(form) && samples == 1 ? 2 : 1;
  Shown wanted{settings(state, pixelScale / static_cast<float>(divisor)),
               shownCamera(state),
               std::max(1, width_ / divisor),
               std::max(1, height_ / divisor),
               samples,
               form,
               content_};
  // Where pictures are slow, the mouse passing over the model must not cost one each time.
  if (smoothSeconds_ > kSmoothWhileMoving) wanted.settings.hoverFace = kNone;
  // A smooth picture gives way to motion.
  if (pending_ && samples < pending_->samples && *pending_ != wanted) pending_.reset();
  // A round that is still being taken in is shown when it is there as a whole.
  const bool takingIn = !floodTaken_ && !state.changing() && wanted.settings.playhead;
  if (!pending_ && !(takingIn && shown_) && (!shown_ || *shown_ != wanted)) {
    begin(wanted);
    // Quick drivers finish it at once; slow ones go on after the window was looked after.
    if (lastSeconds_ < kSecondsAtOnce) goOn();
  }
  return textureId(shown_ ? front_ : back_);
}

std::vector<glm::vec3> SceneView::chartColors(const AppState& state) const {
  std::vector<glm::vec3> colors;
  const Segmentation* labels = state.results().segmentation.get();
  const auto count = static_cast<Index>(labels == nullptr ? 0 : labels->chartCount);
  for (Index c = 0; c < count; ++c) {
    colors.push_back(renderer_.chartColor(c, state.view.render));
  }
  return colors;
}

std::vector<Index> SceneView::chartColorNumbers(const AppState& state) const {
  const Segmentation* labels = segmentation_.get();
  if (!mesh_ || state.results().mesh != mesh_ || labels == nullptr) return {};
  if (recolored_ != state.view.recolored) return {};  // the state knows better
  const auto numbers = renderer_.chartColorNumbers();
  const auto count = std::min<std::size_t>(labels->chartCount, numbers.size());
  return {numbers.begin(), numbers.begin() + static_cast<std::ptrdiff_t>(count)};
}

Pick SceneView::pick(int x, int y) {
  if (!shown_ || !mesh_ || !tree_) return {};
  return pickModel(*tree_, renderer_.bounds(), shown_->camera, {width_, height_, x, y},
                   shownLabels(renderer_.scene()), shown_->settings.hiddenCharts);
}

}  // namespace chartflood
