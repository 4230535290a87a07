#pragma once
/// A renderer without a window that fails a test when the driver complains.

#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/base/log.h"
#include "render/gl/debug.h"
#include "render/gl/offscreen_context.h"
#include "render/passes/offscreen_render.h"
#include "render/passes/renderer.h"
#include "tests/render/shapes.h"

namespace chartflood::test {

/// A current context; skips nothing and hides nothing: without OSMesa and EGL the test fails.
class GlTest : public ::testing::Test {
 protected:
  void SetUp() override {
    context_ = gl::createOffscreenContext();
    context_->makeCurrent();
    gl::logDriverErrors();
    sink_ = addLogSink(LogLevel::Warning,
                       [](LogLevel, const std::string& text) { ADD_FAILURE() << text; });
    renderer_ = std::make_unique<Renderer>();
  }
  void TearDown() override {
    renderer_.reset();
    removeLogSink(sink_);
    context_->release();
    context_.reset();
  }

  void show(std::shared_ptr<const Mesh> mesh) {
    mesh_ = std::move(mesh);
    renderer_->setMesh(mesh_, nullptr);
    camera_ = {};
    camera_.look(StandardView::Oblique);
    camera_.frame(mesh_->positions(), aspect());
  }
  /// One chart a side of a test cube.
  Segmentation cubeSides() const {
    Segmentation segmentation;
    segmentation.chartCount = 6;
    segmentation.complete = true;
    const std::size_t perSide = mesh_->faceCount() / 6;
    for (std::size_t f = 0; f < mesh_->faceCount(); ++f) {
      segmentation.label.push_back(static_cast<Index>(f / perSide));
    }
    segmentation.areas.gaussArea.assign(6, 1.0);
    return segmentation;
  }
  /// Flat colours without marks, for measuring.
  static RenderSettings flat(ColorMode mode) {
    RenderSettings settings;
    settings.colorMode = mode;
    settings.lighting = false;
    settings.seams = settings.seedMarks = settings.scalarBar = false;
    settings.background = backgroundFromText("black");
    return settings;
  }
  Image draw(const RenderSettings& settings) {
    return renderImage(*renderer_, camera_, settings, {kWidth, kHeight, 1, 1});
  }
  double aspect() const { return double(kWidth) / kHeight; }
  /// Pixel where a point of the model appears, not asking whether it is hidden.
  glm::ivec2 pixelOf(const glm::dvec3& point) const {
    const glm::dvec3 ndc = camera_.project(point, aspect(), renderer_->bounds());
    return {static_cast<int>((ndc.x + 1) / 2 * kWidth),
            static_cast<int>((1 - ndc.y) / 2 * kHeight)};
  }
  glm::dvec3 middle(Index triangle) const {
    glm::dvec3 sum(0);
    for (const Index vertex : mesh_->triangles()[triangle]) sum += mesh_->positions()[vertex] / 3.0;
    return sum;
  }
  /// Triangles whose middle is seen, with the pixel.
  struct Seen {
    Index triangle;
    glm::ivec2 pixel;
  };
  std::vector<Seen> seenTriangles() {
    const auto image = renderer_->triangleImage(camera_, kWidth, kHeight);
    std::vector<Seen> seen;
    for (Index t = 0; t < mesh_->triangleCount(); ++t) {
      const glm::ivec2 p = pixelOf(middle(t));
      if (image[static_cast<std::size_t>(p.y * kWidth + p.x)] == t) seen.push_back({t, p});
    }
    return seen;
  }

  static constexpr int kWidth = 320, kHeight = 240;
  std::unique_ptr<gl::Context> context_;
  std::unique_ptr<Renderer> renderer_;
  std::shared_ptr<const Mesh> mesh_;
  Camera camera_;

 private:
  int sink_ = 0;
};

inline Rgba8 toRgba8(const glm::vec3& color) {
  const auto byte = [](float c) { return static_cast<std::uint8_t>(std::lround(c * 255)); };
  return {byte(color.r), byte(color.g), byte(color.b), 255};
}

inline void expectColor(const Rgba8& pixel, const glm::vec3& color, int tolerance = 1) {
  const Rgba8 wanted = toRgba8(color);
  for (std::size_t c = 0; c < 4; ++c) {
    EXPECT_NEAR(int{pixel[c]}, int{wanted[c]}, tolerance) << "channel " << c;
  }
}

}  // namespace chartflood::test
