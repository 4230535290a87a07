// Pictures of the simple form of a surface look like those of the whole.

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "core/gauss/sector_normals.h"
#include "render/scene/simple_surface.h"
#include "tests/render/scene.h"
#include "tests/support/test_meshes.h"

namespace chartflood {
namespace {

class SimplePixels : public test::GlTest {
 protected:
  Image drawAs(SurfaceForm form, const RenderSettings& settings) {
    const gl::Framebuffer target(kWidth, kHeight, 1);
    renderer_->beginDrawing(target, camera_, settings, PicturePart::whole(kWidth, kHeight), form);
    while (!renderer_->continueDrawing(1e-4)) ++pieces_;
    return readFramebuffer(target);
  }
  /// Share of the pixels that either form covers which clearly differ.
  double difference(const RenderSettings& settings) {
    const Image whole = drawAs(SurfaceForm::Whole, settings);
    const Image simple = drawAs(SurfaceForm::Simple, settings);
    int covered = 0, differ = 0;
    for (std::size_t i = 0; i < whole.pixels().size(); ++i) {
      const Rgba8 &a = whole.pixels()[i], &b = simple.pixels()[i];
      const Rgba8 black{0, 0, 0, 255};
      if (a == black && b == black) continue;
      ++covered;
      int most = 0;
      for (std::size_t c = 0; c < 3; ++c) most = std::max(most, std::abs(int{a[c]} - int{b[c]}));
      if (most > 40) ++differ;
    }
    EXPECT_GT(covered, 5000);
    return static_cast<double>(differ) / covered;
  }

  /// What so much of the model spans in the middle of the picture.
  double pixelsOf(double length) const {
    // Three directions at right angles, looked at from anywhere, have twice the square together.
    double squares = 0;
    const glm::dvec3 from = camera_.project(camera_.target, aspect(), renderer_->bounds());
    for (int axis = 0; axis < 3; ++axis) {
      glm::dvec3 end = camera_.target;
      end[axis] += length;
      const glm::dvec3 to = camera_.project(end, aspect(), renderer_->bounds());
      squares += std::pow(0.5 * kWidth * (to.x - from.x), 2);
      squares += std::pow(0.5 * kHeight * (to.y - from.y), 2);
    }
    return std::sqrt(squares / 2);
  }

  int pieces_ = 0;
};

TEST_F(SimplePixels, AreThoseOfTheWholeButForBorders) {
  const auto mesh = test::sampleMesh("torus", 60'000);
  show(mesh);
  const CornerNormals normals = computeCornerNormals(*mesh, 45);
  setNormals(normals);
  Segmentation quarters;
  quarters.chartCount = 4;
  quarters.complete = true;
  quarters.areas.gaussArea.assign(4, 1.0);
  for (std::size_t f = 0; f < mesh->faceCount(); ++f) {
    quarters.label.push_back(static_cast<Index>(4 * f / mesh->faceCount()));
  }
  setCharts(quarters);
  EXPECT_FALSE(renderer_->hasSimpleSurface());
  const RenderSettings settings = flat(ColorMode::Charts);
  EXPECT_EQ(difference(settings), 0) << "without a simple form the whole is drawn";

  const auto simple = simpleSurface(*mesh, *surfaceVertices(*mesh, &normals), nullptr, 12'000);
  setSimple(*simple);
  ASSERT_TRUE(renderer_->hasSimpleSurface());
  const double detail = renderer_->simpleDetail(camera_, PicturePart::whole(kWidth, kHeight));
  EXPECT_NEAR(detail, pixelsOf(simple->detail), 0.05 * detail);
  const double charts = difference(settings);
  EXPECT_GT(charts, 0) << "the simple form was not drawn";
  EXPECT_LT(charts, 0.03);
  EXPECT_GT(pieces_, 2) << "drawn piece by piece";

  RenderSettings lit = settings;
  lit.lighting = true;
  lit.edges = true;  // which the simple form leaves out
  lit.edgeWidth = 0.01f;
  EXPECT_LT(difference(lit), 0.06);

  RenderSettings hidden = settings;
  hidden.hiddenCharts = {1, 2};
  EXPECT_LT(difference(hidden), 0.06);

  setSimple({});
  EXPECT_FALSE(renderer_->hasSimpleSurface());
}

TEST_F(SimplePixels, CarryTheTextureUntilItChanges) {
  const auto mesh = test::plate(200, 100);
  show(mesh);
  camera_.look(StandardView::Front);
  camera_.frame(mesh->positions(), aspect());
  std::vector<glm::vec2> uv;
  for (Index t = 0; t < mesh->triangleCount(); ++t) {
    for (const Index v : mesh->triangles()[t]) {
      const glm::vec2 place(mesh->positions()[v]);
      uv.push_back(t / 2 % 200 < 100 ? place : 0.5f * glm::vec2(5 - place.y, place.x));
    }
  }
  setCornerUv(uv);
  RenderSettings settings = flat(ColorMode::Checkerboard);
  settings.checkerKind = CheckerKind::Squares;
  settings.checkerSquares = 12;
  const auto layout = renderer_->textureLayout();
  ASSERT_EQ(layout->firstTriangle.size(), 2u);
  setSimple(*simpleSurface(*mesh, *surfaceVertices(*mesh, nullptr), layout.get(), 10'000));
  EXPECT_LT(difference(settings), 0.06);
  setCornerUv(uv);
  EXPECT_FALSE(renderer_->hasSimpleSurface()) << "its places are those of another texture";
}

}  // namespace
}  // namespace chartflood
