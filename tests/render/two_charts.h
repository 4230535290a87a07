#pragma once
/// A plate of two charts whose texture places are known: what stands where can be worked out by
/// hand.

#include <cmath>
#include <vector>

#include "tests/render/scene.h"

namespace chartflood::test {

/// 16 x 8 squares. The left half is chart 0, at 1/20 texture units a square; the right half is
/// chart 1, half as large and turned by a quarter.
class TwoCharts : public GlTest {
 protected:
  static constexpr int kColumns = 16, kRows = 8;

  void SetUp() override {
    GlTest::SetUp();
    show(plate(kColumns, kRows));
    segmentation_.chartCount = 2;
    segmentation_.complete = true;
    segmentation_.areas.gaussArea = {1, 1};
    for (Index t = 0; t < mesh_->triangleCount(); ++t) segmentation_.label.push_back(chartOf(t));
    setCharts(segmentation_);
    setCornerUv(cornerUv());
    camera_.orthographic = true;
    camera_.look(StandardView::Front);
    camera_.frame(mesh_->positions(), aspect());
  }
  static Index chartOf(Index triangle) { return triangle / 2 % kColumns < kColumns / 2 ? 0 : 1; }
  /// A place of the plate in squares, from its position in the mesh.
  glm::dvec2 onPlate(const glm::dvec3& position) const {
    return glm::dvec2(position * mesh_->scale() + mesh_->center());
  }
  glm::dvec3 inSpace(double x, double y) const {
    return (glm::dvec3(x, y, 0) - mesh_->center()) / mesh_->scale();
  }
  static glm::vec2 uvAt(Index chart, const glm::dvec2& p) {
    if (chart == 0) return {0.05 + p.x / 20, 0.05 + p.y / 20};
    return {0.9 - p.y / 40, 0.1 + (p.x - 8) / 40};
  }
  std::vector<glm::vec2> cornerUv() const {
    std::vector<glm::vec2> uv;
    for (Index t = 0; t < mesh_->triangleCount(); ++t) {
      for (const Index v : mesh_->triangles()[t]) {
        uv.push_back(uvAt(chartOf(t), onPlate(mesh_->positions()[v])));
      }
    }
    return uv;
  }
  /// The side of the mesh from one corner of the plate's squares to the next.
  Index sideBetween(const glm::ivec2& from, const glm::ivec2& to) const {
    const auto vertex = [](const glm::ivec2& p) {
      return static_cast<Index>(p.y * (kColumns + 1) + p.x);
    };
    for (Index side = 0; side < 3 * mesh_->triangleCount(); ++side) {
      if (mesh_->sideStart(side) == vertex(from) && mesh_->sideEnd(side) == vertex(to)) return side;
    }
    ADD_FAILURE() << "the plate has no such side";
    return 0;
  }
  /// A cut upwards through the middle of chart 0.
  std::vector<Index> cut() const {
    std::vector<Index> sides;
    for (int y = 1; y < 6; ++y) sides.push_back(sideBetween({4, y}, {4, y + 1}));
    return sides;
  }

  Segmentation segmentation_;
};

}  // namespace chartflood::test
