// What lies where in a picture: picking, and places for chart numbers.

#include <algorithm>
#include <cmath>

#include <glm/gtc/matrix_inverse.hpp>

#include "render/gl/objects.h"
#include "render/renderer.h"
#include "render/texture_units.h"

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

/// Distance of each pixel to the border of its region, by two sweeps over the picture (chamfer
/// distance with steps 1 and sqrt 2); 0 outside all charts.
std::vector<float> distanceToBorder(const std::vector<Index>& chart, int width, int height) {
  constexpr float kDiagonal = 1.41421356f;
  std::vector<float> distance(chart.size(), 0.0f);
  const auto index = [&](int x, int y) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(x);
  };
  const auto via = [&](std::size_t here, int x, int y, float step) {
    if (x < 0 || y < 0 || x >= width || y >= height) return step;
    const std::size_t there = index(x, y);
    return chart[there] == chart[here] ? distance[there] + step : step;
  };
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const std::size_t here = index(x, y);
      if (chart[here] == kNone) continue;
      distance[here] =
          std::min({via(here, x - 1, y, 1), via(here, x, y - 1, 1),
                    via(here, x - 1, y - 1, kDiagonal), via(here, x + 1, y - 1, kDiagonal)});
    }
  }
  for (int y = height; y-- > 0;) {
    for (int x = width; x-- > 0;) {
      const std::size_t here = index(x, y);
      if (chart[here] == kNone) continue;
      distance[here] =
          std::min({distance[here], via(here, x + 1, y, 1), via(here, x, y + 1, 1),
                    via(here, x + 1, y + 1, kDiagonal), via(here, x - 1, y + 1, kDiagonal)});
    }
  }
  return distance;
}

}  // namespace

void Renderer::drawIds(const Eye& eye, int width, int height, std::vector<GLuint>& ids,
                       float* depth) {
  const gl::FramebufferScope keep;
  charts_->update(lastSettings_, flood_->longestTime());
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
  idProgram_.use();
  setEye(idProgram_, eye);
  charts_->bindLabels(units::kLabels);
  charts_->bindColors(units::kChartColors);
  idProgram_.set("uLabels", static_cast<int>(units::kLabels));
  idProgram_.set("uChartColors", static_cast<int>(units::kChartColors));
  surface_->draw(lastSettings_.hiddenCharts.empty());
  ids.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0);
  glReadPixels(0, 0, width, height, GL_RED_INTEGER, GL_UNSIGNED_INT, ids.data());
  if (depth) glReadPixels(0, 0, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, depth);
  glDisable(GL_DEPTH_TEST);
  glUseProgram(0);
  glActiveTexture(GL_TEXTURE0);
}

Pick Renderer::pick(const Camera& camera, int width, int height, int x, int y) {
  Pick pick;
  if (!mesh_ || x < 0 || y < 0 || x >= width || y >= height) return pick;
  const PicturePart pixel{width, height, x, height - 1 - y, 1, 1};
  std::vector<GLuint> ids;
  float depth = 1;
  drawIds(makeEye(camera, bounds_, pixel), 1, 1, ids, &depth);
  if (ids[0] == 0) return pick;
  pick.triangle = ids[0] - 1;
  pick.face = mesh_->faceOf(pick.triangle);
  pick.chart = charts_->chartOf(pick.triangle);
  const double aspect = double(width) / height;
  const glm::dvec4 clip(2 * (x + 0.5) / width - 1, 1 - 2 * (y + 0.5) / height, 2.0 * depth - 1, 1);
  const glm::dvec4 point =
      glm::inverse(camera.projectionMatrix(aspect, bounds_) * camera.viewMatrix()) * clip;
  pick.point = glm::dvec3(point) / point.w;
  return pick;
}

std::vector<Index> Renderer::triangleImage(const Camera& camera, int width, int height) {
  const auto rowLength = static_cast<std::ptrdiff_t>(width);
  std::vector<Index> image(static_cast<std::size_t>(width) * static_cast<std::size_t>(height),
                           kNone);
  if (!mesh_) return image;
  std::vector<GLuint> ids;
  drawIds(makeEye(camera, bounds_, PicturePart::whole(width, height)), width, height, ids, nullptr);
  for (int y = 0; y < height; ++y) {
    const auto from = ids.begin() + (height - 1 - y) * rowLength;
    std::transform(from, from + rowLength, image.begin() + y * rowLength,
                   [](GLuint id) { return id == 0 ? kNone : id - 1; });
  }
  return image;
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
    if (pixel == kNone) continue;
    const glm::uvec2 taken = flood_->taken()[pixel];
    if (!settings.playhead)
      pixel = charts_->chartOf(pixel);
    else
      pixel = taken.x < *settings.playhead ? taken.y : kNone;
  }
  const std::vector<float> distance = distanceToBorder(chart, w, h);
  std::vector<ChartLabel> best(charts_->chartCount());
  for (std::size_t i = 0; i < chart.size(); ++i) {
    if (chart[i] == kNone || distance[i] <= best[chart[i]].room) continue;
    const auto column = static_cast<float>(i % static_cast<std::size_t>(w));
    const std::size_t line = i / static_cast<std::size_t>(w);
    const auto row = static_cast<float>(line);
    best[chart[i]] = {chart[i], {column + 0.5f, row + 0.5f}, distance[i]};
  }
  std::erase_if(best, [](const ChartLabel& label) { return label.chart == kNone; });
  const glm::vec2 enlarge(static_cast<float>(width) / static_cast<float>(w),
                          static_cast<float>(height) / static_cast<float>(h));
  for (ChartLabel& label : best) {
    label.place *= enlarge;
    label.room *= std::min(enlarge.x, enlarge.y);
  }
  return best;
}

}  // namespace chartflood
