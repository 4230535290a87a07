// The course of a picture of the model, piece by piece where the driver is slow.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <utility>

#include "core/base/check.h"
#include "render/passes/renderer.h"

namespace chartflood {

void Renderer::warmUp(const RenderSettings& settings, std::span<const int> samples,
                      SurfaceForm form) {
  if (!mesh_) return;
  constexpr int kSize = 8;
  const Camera camera;
  for (const int count : samples) {
    const gl::Framebuffer target(kSize, kSize, count);
    for (const bool playing : {false, true}) {
      RenderSettings wanted = settings;
      wanted.playhead.reset();
      if (playing) wanted.playhead = 1;
      beginDrawing(target, camera, wanted, PicturePart::whole(kSize, kSize), form);
      const gl::FramebufferScope keep;
      target.bindForDrawing();
      useColorMap(wanted);
      glEnable(GL_BLEND);
      glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
      drawSurface(frameOf(*unfinished_), 0, 1);
      glDisable(GL_BLEND);
      glFinish();
      unfinished_.reset();
    }
  }
}

unsigned Renderer::hoveredChart(const RenderSettings& settings) const {
  if (settings.hoverFace >= mesh_->faceCount()) return settings.hoverChart;
  return shownChart(mesh_->triangleBegin(settings.hoverFace), settings);
}

Index Renderer::shownChart(Index triangle, const RenderSettings& settings) const {
  if (!settings.playhead) return charts_->chartOf(triangle);
  const glm::uvec2 taken = flood_->taken(triangle);
  return taken.x < *settings.playhead ? taken.y : kNone;
}

Renderer::Frame Renderer::frameOf(const Unfinished& picture) const {
  Frame frame{picture.settings,
              {},
              0,
              picture.inTexture,
              picture.simple,
              glm::vec2(picture.part.left, picture.part.bottom)};
  if (picture.inTexture) {
    frame.eye = makeEye(picture.uvCamera, picture.part);
    frame.dash = dashLength(frame.eye.pixel, picture.settings);
    return frame;
  }
  frame.eye = makeEye(picture.camera, bounds_, picture.part);
  const double distance = picture.camera.orthographic ? 1 : picture.camera.distance;
  frame.dash = dashLength(frame.eye.pixel * static_cast<float>(distance), picture.settings);
  return frame;
}

float Renderer::dashLength(float pixel, const RenderSettings& settings) {
  constexpr float kPixels = 13;  // a dash and a gap
  return std::exp2(std::round(std::log2(kPixels * settings.pixelScale * pixel)));
}

void Renderer::draw(const gl::Framebuffer& target, const Camera& camera,
                    const RenderSettings& settings) {
  draw(target, camera, settings, PicturePart::whole(target.width(), target.height()));
}

void Renderer::draw(const gl::Framebuffer& target, const Camera& camera,
                    const RenderSettings& settings, const PicturePart& part) {
  beginDrawing(target, camera, settings, part);
  continueDrawing(std::numeric_limits<double>::infinity());
}

void Renderer::beginDrawing(const gl::Framebuffer& target, const Camera& camera,
                            const RenderSettings& settings, const PicturePart& part,
                            SurfaceForm form) {
  Unfinished picture{&target, camera, settings, part};
  picture.simple = form == SurfaceForm::Simple && hasSimpleSurface();
  begin(std::move(picture));
}

/// Values of charts are those of the mode, where it has some.
void Renderer::updateCharts(const RenderSettings& settings) {
  const bool valued = fillOf(settings) == SurfaceFill::ChartValue;
  charts_->update(settings, flood_->longestTime(),
                  valued ? std::span<const float>(valuesOf(settings.colorMode).values)
                         : std::span<const float>());
}

bool Renderer::hasSimpleSurface() const { return mesh_ && surface_->simpleCount() > 0; }

double Renderer::simpleDetail(const Camera& camera, const PicturePart& part) const {
  if (!hasSimpleSurface()) return 0;
  const double pixel = static_cast<double>(makeEye(camera, bounds_, part).pixel);
  return surface_->simpleDetail() / (pixel * (camera.orthographic ? 1 : camera.distance));
}

void Renderer::begin(Unfinished picture) {
  const gl::Framebuffer& target = *picture.target;
  CF_CHECK(picture.part.width == target.width() && picture.part.height == target.height());
  const gl::FramebufferScope keep;
  lastSettings_ = picture.settings;
  unfinished_.emplace(std::move(picture));
  target.bindForDrawing();
  glDisable(GL_SCISSOR_TEST);
  glDisable(GL_CULL_FACE);
  glDisable(GL_BLEND);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glDepthMask(GL_TRUE);
  glClearColor(0, 0, 0, 0);
  glClearDepth(1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  const Frame frame = frameOf(*unfinished_);
  drawBackground(frame);
  if (!frame.inTexture || !unfinished_->uvStyle.frame) return;
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  drawUvGround(frame, unfinished_->uvCamera);
  glDisable(GL_BLEND);
}

bool Renderer::continueDrawing(double seconds) {
  if (!unfinished_) return true;
  const gl::FramebufferScope keep;
  Unfinished& picture = *unfinished_;
  const Frame frame = frameOf(picture);
  useColorMap(picture.settings);
  picture.target->bindForDrawing();
  glDisable(GL_SCISSOR_TEST);
  glDisable(GL_CULL_FACE);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glDepthMask(GL_TRUE);
  glDepthFunc(GL_LEQUAL);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);  // colours are premultiplied
  if (frame.inTexture)
    glDisable(GL_DEPTH_TEST);
  else
    glEnable(GL_DEPTH_TEST);
  if (mesh_) updateCharts(picture.settings);
  const bool ready = drawSurfacePieces(frame, picture, seconds);
  if (ready && frame.inTexture)
    finishUv(frame, picture);
  else if (ready && mesh_)
    finishScene(frame, picture.camera);
  glDisable(GL_BLEND);
  glDisable(GL_DEPTH_TEST);
  glUseProgram(0);
  glActiveTexture(GL_TEXTURE0);
  if (!ready) return false;
  picture.target->resolve();
  unfinished_.reset();
  return true;
}

void Renderer::finishScene(const Frame& frame, const Camera& camera) {
  glDepthMask(GL_FALSE);
  drawLines(frame);
  drawMarks(frame);
  glDepthMask(GL_TRUE);
  drawOverlay(frame, camera);
}

/// True when the whole surface is drawn.
bool Renderer::drawSurfacePieces(const Frame& frame, Unfinished& picture, double seconds) {
  if (!mesh_ || (frame.inTexture && (!uv_ || !picture.uvStyle.fill))) return true;
  if (seconds == std::numeric_limits<double>::infinity()) {
    drawSurface(frame, picture.nextTriangle, drawnTriangles(frame));
    return true;
  }
  using Clock = std::chrono::steady_clock;
  const auto since = [](Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
  };
  const Clock::time_point start = Clock::now();
  const std::size_t count = drawnTriangles(frame);
  while (picture.nextTriangle < count) {
    const Clock::time_point pieceStart = Clock::now();
    picture.nextTriangle = drawSurface(frame, picture.nextTriangle, picture.pieceSize);
    glFinish();
    // Three pieces in the time that there is, so that it is not missed by much.
    const double share = seconds / 3 / std::max(since(pieceStart), 1e-6);
    picture.pieceSize = static_cast<std::size_t>(std::clamp(
        static_cast<double>(picture.pieceSize) * std::clamp(share, 0.3, 4.0), 2000.0, 1e9));
    if (since(start) >= seconds * 2 / 3) break;
  }
  return picture.nextTriangle >= count;
}

void Renderer::drawBackground(const Frame& frame) {
  const Background& background = frame.settings.background;
  if (background.transparent) return;
  glDisable(GL_DEPTH_TEST);
  backgroundProgram_.use();
  backgroundProgram_.set("uTile", frame.eye.tile);
  backgroundProgram_.set("uBottom", glm::vec4(background.bottom, 1));
  backgroundProgram_.set("uTop", glm::vec4(background.top, 1));
  glBindVertexArray(emptyVertexArray_.id());
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace chartflood
