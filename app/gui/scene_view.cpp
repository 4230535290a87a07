#include "app/gui/scene_view.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "app/gui/imgui_gl.h"
#include "core/gauss/sector_normals.h"

namespace chartflood {

namespace {

constexpr int kSmoothSamples = 4;
constexpr double kSmoothWhileMoving = 0.012;  // seconds a smooth picture may take in motion
constexpr double kSecondsAPass = 0.012;       // of drawing before the window is looked after
constexpr double kCoarseFrom = 0.045;         // slower plain pictures get half the size in motion
constexpr double kCoarseUntil = 0.012;        // quicker coarse ones get their full size back

double secondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

bool isReady(const std::future<CornerNormals>& future) {
  return future.valid() && future.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
}

}  // namespace

RenderSettings sceneSettings(const AppState& state, float pixelScale) {
  RenderSettings settings = state.view.render;
  settings.pixelScale = pixelScale;
  settings.playhead.reset();
  if (!state.showsFinal()) settings.playhead = state.playback.playhead();
  settings.hoverFace = state.hoveredFace;
  settings.selectedCharts.clear();
  if (state.selectedChart != kNone) settings.selectedCharts.push_back(state.selectedChart);
  return settings;
}

SceneView::SceneView(std::function<void()> wake) : wake_(std::move(wake)) {}

void SceneView::takeMesh(const Results& results) {
  if (results.mesh == mesh_) return;
  mesh_ = results.mesh;
  renderer_.setMesh(mesh_, nullptr);
  gaussArea_.reset();
  segmentation_.reset();
  record_.reset();
  seeds_.clear();
  normalsAngle_ = -1;
  ++content_;
}

void SceneView::takeNormals(const Results& results) {
  if (isReady(normals_)) {
    const CornerNormals normals = normals_.get();
    if (normalsMesh_ == mesh_) renderer_.setNormals(&normals);
    ++content_;
  }
  if (!mesh_ || !results.gaussArea || normals_.valid()) return;
  const double angle = results.gaussArea->sharpAngle;
  if (angle == normalsAngle_ && normalsMesh_ == mesh_) return;
  normalsAngle_ = angle;
  normalsMesh_ = mesh_;
  normals_ = std::async(std::launch::async, [mesh = mesh_, angle, wake = wake_] {
    CornerNormals normals = computeCornerNormals(*mesh, angle);
    wake();
    return normals;
  });
}

void SceneView::takeFlood(const Results& results) {
  if (results.record != record_) {
    record_ = results.record;
    recorded_ = 0;
    renderer_.setFlood(record_);
    ++content_;
  }
  if (record_ && record_->size() != recorded_) {
    recorded_ = record_->size();
    renderer_.updateFlood();
    ++content_;
  }
  if (results.seeds != seeds_) {
    seeds_ = results.seeds;
    std::vector<SeedMark> marks;
    for (std::size_t i = 0; i < seeds_.size(); ++i) {
      marks.push_back({seeds_[i], static_cast<Index>(i), false});
    }
    renderer_.setSeeds(marks);
    ++content_;
  }
}

void SceneView::takeIn(const AppState& state) {
  const Results& results = state.results();
  takeMesh(results);
  if (!mesh_) return;
  if (results.gaussArea != gaussArea_) {
    gaussArea_ = results.gaussArea;
    renderer_.setGaussArea(gaussArea_.get());
    ++content_;
  }
  takeNormals(results);
  if (results.segmentation != segmentation_) {
    segmentation_ = results.segmentation;
    renderer_.setSegmentation(segmentation_.get());
    ++content_;
  }
  takeFlood(results);
}

int SceneView::samplesFor(bool moving) const {
  return moving && smoothSeconds_ > kSmoothWhileMoving ? 1 : kSmoothSamples;
}

void SceneView::begin(const Shown& wanted) {
  const bool fits = back_.width() == wanted.width && back_.height() == wanted.height &&
                    backSamples_ == wanted.samples;
  if (!fits) back_ = gl::Framebuffer(wanted.width, wanted.height, wanted.samples);
  backSamples_ = wanted.samples;
  renderer_.beginDrawing(back_, wanted.camera, wanted.settings,
                         PicturePart::whole(wanted.width, wanted.height));
  pending_ = wanted;
  pendingSeconds_ = 0;
}

/// Draws on; when the picture is finished it is the one to show.
void SceneView::goOn() {
  const auto start = std::chrono::steady_clock::now();
  const bool ready = renderer_.continueDrawing(kSecondsAPass);
  if (ready) glFinish();  // the cost decides on the smoothing of the next pictures
  pendingSeconds_ += secondsSince(start);
  if (!ready) return;
  if (pending_->samples == kSmoothSamples) {
    smoothSeconds_ = pendingSeconds_;
  } else {
    coarse_ = pendingSeconds_ > (coarse_ ? kCoarseUntil : kCoarseFrom);
  }
  std::swap(front_, back_);
  std::swap(frontSamples_, backSamples_);
  shown_ = std::exchange(pending_, std::nullopt);
}

ImTextureID SceneView::picture(const AppState& state, int width, int height, float pixelScale,
                               bool moving) {
  const gl::FramebufferScope keep;
  takeIn(state);
  width_ = std::max(1, width);
  height_ = std::max(1, height);
  const int samples = samplesFor(moving);
  const int divisor = coarse_ && samples == 1 ? 2 : 1;
  Shown wanted{sceneSettings(state, pixelScale / static_cast<float>(divisor)),
               state.view.camera,
               std::max(1, width_ / divisor),
               std::max(1, height_ / divisor),
               samples,
               content_};
  // Where pictures are slow, the mouse passing over the model must not cost one each time.
  if (smoothSeconds_ > kSmoothWhileMoving) wanted.settings.hoverFace = kNone;
  // A picture under way is finished even when a newer one is wanted, or none would ever be while
  // things move; only a smooth one gives way to motion.
  const bool gone = pending_ && !renderer_.drawing();
  const bool tooFine = pending_ && samples < pending_->samples && *pending_ != wanted;
  if (gone || tooFine) pending_.reset();
  if (!pending_ && (!shown_ || *shown_ != wanted)) begin(wanted);
  if (pending_) goOn();
  if (pending_ || *shown_ != wanted) wake_();
  if (!shown_) return textureId(back_.texture());
  return textureId(front_.texture());
}

Pick SceneView::pick(int x, int y) {
  if (!shown_ || !mesh_) return {};
  const auto start = std::chrono::steady_clock::now();
  const gl::FramebufferScope keep;
  const Pick pick = renderer_.pick(shown_->camera, width_, height_, x, y);
  pickSeconds_ = secondsSince(start);
  return pick;
}

}  // namespace chartflood
