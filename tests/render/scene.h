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

inline render::Scene sceneOf(std::shared_ptr<const Mesh> mesh) {
  render::Scene scene;
  scene.source.mesh = std::move(mesh);
  return scene;
}

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
    scene_ = sceneOf(mesh_);
    renderer_->show(scene_);
    camera_ = {};
    camera_.look(StandardView::Oblique);
    camera_.frame(mesh_->positions(), aspect());
  }
  // Each shows one part more of the scene, or another in its place.
  void setCharts(const Segmentation& charts) { showPart(scene_.source.segmentation, charts); }
  void setLabels(const std::vector<Index>& labels) { showPart(scene_.labels, labels); }
  void setStats(const ChartStats& stats) { showPart(scene_.source.stats, stats); }
  void setSeeds(const std::vector<SeedMark>& seeds) { showPart(scene_.seeds, seeds); }
  void setCuts(const std::vector<Index>& sides) { showPart(scene_.cuts, sides); }
  void setMarks(const SurfaceMarks& marks) { showPart(scene_.marks, marks); }
  void setUnwrap(const Unwrap& unwrap) { showPart(scene_.source.unwrap, unwrap); }
  void setSimple(const SimpleSurface& simple) { showPart(scene_.simple, simple); }
  void setGaussArea(const GaussArea& area) {
    showPart(scene_.source.gauss, gaussValues(*mesh_, area));
  }
  void setNormals(const CornerNormals& normals) {
    scene_.vertices = surfaceVertices(*mesh_, &normals);
    renderer_->show(scene_);
  }
  void setCornerUv(const std::vector<glm::vec2>& uv) {
    showPart(scene_.source.layout, uv.empty() ? UvLayout{} : uvLayout(*mesh_, uv));
  }
  /// With the entries that it has by now; false when some of them are not taken in yet.
  bool setFlood(std::shared_ptr<const FloodRecord> record,
                std::size_t most = Renderer::kWholeFlood) {
    scene_.source.record = std::move(record);
    return updateFlood(most);
  }
  bool updateFlood(std::size_t most = Renderer::kWholeFlood) {
    scene_.source.recorded = scene_.source.record->size();
    return renderer_->show(scene_, most);
  }
  Pick pick(const glm::ivec2& p, const std::vector<Index>& hidden = {}, int width = kWidth,
            int height = kHeight) const {
    return pickModel(TriangleTree(mesh_), renderer_->bounds(), camera_, {width, height, p.x, p.y},
                     shownLabels(scene_), hidden);
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
  render::Scene scene_;
  Camera camera_;

 private:
  template <typename Value>
  void showPart(std::shared_ptr<const Value>& part, const Value& value) {
    part = std::make_shared<const Value>(value);
    renderer_->show(scene_);
  }

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
