// What lies where in a picture: picking, and places for chart numbers.

#include <algorithm>
#include <cmath>
#include <utility>

#include "render/gl/objects.h"
#include "render/passes/renderer.h"
#include "render/passes/texture_units.h"

namespace chartflood {

namespace {

/// A small framebuffer of triangle numbers with depth.
struct IdTarget {
  gl::FramebufferObject framebuffer = gl::FramebufferObject::create();
  gl::Renderbuffer ids = gl::Renderbuffer::create(), depth = gl::Renderbuffer::create();

  IdTarget(int width, int height) {
    glBindRenderbuffer(GL_RENDERBUFFER, ids.id());
    glRenderbufferStorage(GL_RENDERBUFFER, GL_R32UI, width, height);
    glBindRenderbuffer(GL_RENDERBUFFER, depth.id());
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, width, height);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, ids.id());
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth.id());
    glViewport(0, 0, width, height);
  }
};

std::vector<Index> emptyImage(int width, int height) {
  return std::vector<Index>(static_cast<std::size_t>(width) * static_cast<std::size_t>(height),
                            kNone);
}

/// Triangle numbers, the bottom row of `ids` last.
std::vector<Index> fromTop(const std::vector<GLuint>& ids, int width, int height) {
  const auto rowLength = static_cast<std::ptrdiff_t>(width);
  std::vector<Index> image = emptyImage(width, height);
  for (int y = 0; y < height; ++y) {
    const auto from = ids.begin() + (height - 1 - y) * rowLength;
    std::transform(from, from + rowLength, image.begin() + y * rowLength,
                   [](GLuint id) { return id == 0 ? kNone : id - 1; });
  }
  return image;
}

}  // namespace

std::vector<GLuint> Renderer::drawIds(gl::Program& program, const Eye& eye, int width, int height,
                                      const RenderSettings& settings) {
  const gl::FramebufferScope keep;
  updateCharts(settings);
  const IdTarget target(width, height);
  const GLuint none[4] = {0, 0, 0, 0};
  const GLfloat farthest = 1;
  glDisable(GL_BLEND);
  glDisable(GL_SCISSOR_TEST);
  glDisable(GL_CULL_FACE);
  glDepthMask(GL_TRUE);
  glDepthFunc(GL_LEQUAL);
  glEnable(GL_DEPTH_TEST);
  glClearBufferuiv(GL_COLOR, 0, none);
  glClearBufferfv(GL_DEPTH, 0, &farthest);
  program.use();
  setEye(program, eye);
  charts_->bindLabels(units::kLabels);
  charts_->bindColors(units::kChartColors);
  program.set("uLabels", static_cast<int>(units::kLabels));
  program.set("uChartColors", static_cast<int>(units::kChartColors));
  const bool flat = &program == &idUvProgram_;
  surface_->draw(settings.hiddenCharts.empty() && !flat);
  std::vector<GLuint> ids(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0);
  glReadPixels(0, 0, width, height, GL_RED_INTEGER, GL_UNSIGNED_INT, ids.data());
  glDisable(GL_DEPTH_TEST);
  glUseProgram(0);
  glActiveTexture(GL_TEXTURE0);
  return ids;
}

std::vector<Index> Renderer::triangleImage(const Camera& camera, int width, int height) {
  if (!mesh_) return emptyImage(width, height);
  return fromTop(drawIds(idProgram_, makeEye(camera, bounds_, PicturePart::whole(width, height)),
                         width, height, lastSettings_),
                 width, height);
}

std::vector<ChartLabel> Renderer::chartLabels(const Camera& camera, const RenderSettings& settings,
                                              int width, int height) {
  if (!mesh_) return {};
  constexpr int kLongest = 400;  // of the picture that is searched; numbers need no more
  const double shrink = std::min(1.0, double(kLongest) / std::max(width, height));
  const int w = std::max(1, static_cast<int>(std::lround(width * shrink)));
  const int h = std::max(1, static_cast<int>(std::lround(height * shrink)));
  std::vector<Index> chart = triangleImage(camera, w, h);
  for (Index& pixel : chart) {
    if (pixel != kNone) pixel = shownChart(pixel, settings);
  }
  std::vector<ChartLabel> best = interiorPlaces(chart, w, h, charts_->chartCount());
  const glm::vec2 enlarge(static_cast<float>(width) / static_cast<float>(w),
                          static_cast<float>(height) / static_cast<float>(h));
  for (ChartLabel& label : best) {
    label.place *= enlarge;
    label.room *= std::min(enlarge.x, enlarge.y);
  }
  return best;
}

Pick Renderer::pickUv(const UvCamera& camera, int width, int height, int x, int y) {
  if (!uv_ || x < 0 || y < 0 || x >= width || y >= height) return {};
  const PicturePart pixel{width, height, x, height - 1 - y, 1, 1};
  const std::vector<GLuint> ids =
      drawIds(idUvProgram_, makeEye(camera, pixel), 1, 1, lastSettings_);
  if (ids[0] == 0) return {};
  Pick pick;
  pick.triangle = ids[0] - 1;
  pick.face = mesh_->faceOf(pick.triangle);
  pick.chart = charts_->chartOf(pick.triangle);
  const glm::dvec2 uv = camera.toUv({x + 0.5, y + 0.5}, {width, height});
  pick.point = uv_->surfacePoint(pick.triangle, uv);
  return pick;
}

std::vector<Index> Renderer::triangleImage(const UvCamera& camera, int width, int height) {
  if (!uv_) return emptyImage(width, height);
  return fromTop(drawIds(idUvProgram_, makeEye(camera, PicturePart::whole(width, height)), width,
                         height, lastSettings_),
                 width, height);
}

}  // namespace chartflood
