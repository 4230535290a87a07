#include <cmath>

#include "tests/render/scene.h"

namespace chartflood {
namespace {

/// The Gauss area of a cube made by hand, so that these tests stand on the renderer alone: an
/// eighth of the sphere at each corner, nothing on its edges and faces.
GaussArea cubeGauss(const Mesh& mesh) {
  GaussArea gauss;
  gauss.triangle.assign(mesh.triangleCount(), 0.0);
  const auto onCorner = [](const glm::dvec3& p) {
    return std::abs(std::abs(p.x) - std::abs(p.y)) < 1e-9 &&
           std::abs(std::abs(p.x) - std::abs(p.z)) < 1e-9 && std::abs(p.x) > 0.28;
  };
  for (Index v = 0; v < mesh.vertexCount(); ++v) {
    if (!onCorner(mesh.positions()[v])) continue;
    gauss.corners.push_back(v);
    gauss.corner.push_back(std::acos(-1.0) / 2);
  }
  const std::size_t perSide = mesh.triangleCount() / 6;
  for (Index side = 0; side < mesh.opposite().size(); ++side) {
    const Index other = mesh.opposite()[side];
    if (other < side || side / 3 / perSide == other / 3 / perSide) continue;
    gauss.sharpEdges.push_back(side);
    gauss.edge.push_back(0);
  }
  return gauss;
}

class GaussPixels : public test::GlTest {};

bool isReddish(const Rgba8& c) { return c[0] > c[1] + 60 && c[0] > c[2] + 40; }

TEST_F(GaussPixels, DiscsSitAtACubesCornersOnly) {
  show(test::cube(4));
  const GaussArea gauss = cubeGauss(*mesh_);
  ASSERT_EQ(gauss.corners.size(), 8u);
  setGaussArea(gauss);
  const Image image = draw(flat(ColorMode::GaussVertex));
  int discs = 0;
  for (const Index corner : gauss.corners) {
    const glm::dvec3& place = mesh_->positions()[corner];
    // The one corner that an oblique view hides is the farthest from the eye.
    if (glm::distance(place, camera_.eye()) > camera_.distance + 0.4) continue;
    const glm::ivec2 p = pixelOf(place);
    EXPECT_TRUE(isReddish(image.at(p.x, p.y))) << corner;
    ++discs;
  }
  EXPECT_EQ(discs, 7);
  for (const auto& [triangle, pixel] : seenTriangles()) {
    EXPECT_FALSE(isReddish(image.at(pixel.x, pixel.y)));
  }
}

TEST_F(GaussPixels, CreasesAreLinesInTheColourOfTheirValue) {
  show(test::cube(4));
  GaussArea gauss = cubeGauss(*mesh_);
  // Half of the creases carry area, the others none.
  for (std::size_t i = 0; i < gauss.edge.size(); i += 2) gauss.edge[i] = 0.1;
  setGaussArea(gauss);
  const Image image = draw(flat(ColorMode::GaussEdge));
  const auto triangles = renderer_->triangleImage(camera_, kWidth, kHeight);
  int red = 0, pale = 0;
  for (std::size_t i = 0; i < gauss.sharpEdges.size(); ++i) {
    const Index side = gauss.sharpEdges[i];
    const glm::dvec3 middle = 0.5 * (mesh_->positions()[mesh_->sideStart(side)] +
                                     mesh_->positions()[mesh_->sideEnd(side)]);
    const glm::ivec2 p = pixelOf(middle);
    const Index seen = triangles[static_cast<std::size_t>(p.y * kWidth + p.x)];
    if (seen != side / 3 && seen != mesh_->opposite()[side] / 3) continue;
    EXPECT_EQ(isReddish(image.at(p.x, p.y)), gauss.edge[i] > 0) << i;
    ++(gauss.edge[i] > 0 ? red : pale);
  }
  EXPECT_GT(red, 8);
  EXPECT_GT(pale, 8);
}

TEST_F(GaussPixels, CurvedFacesGetStrongColoursFlatOnesStayPale) {
  show(test::cube(4));
  GaussArea gauss = cubeGauss(*mesh_);
  const std::size_t perSide = mesh_->triangleCount() / 6;
  for (std::size_t t = 0; t < gauss.triangle.size(); ++t) {
    gauss.triangle[t] = (t / perSide) % 2 == 0 ? 0.0 : 0.2;
  }
  setGaussArea(gauss);
  const Image image = draw(flat(ColorMode::GaussFace));
  for (const auto& [triangle, pixel] : seenTriangles()) {
    const Rgba8 c = image.at(pixel.x, pixel.y);
    if (gauss.triangle[triangle] == 0)
      EXPECT_GT(std::min({c[0], c[1], c[2]}), 200);
    else
      EXPECT_TRUE(isReddish(c)) << triangle;
  }
}

TEST(SmoothDensity, KeepsTheSumAndLevelsNoise) {
  const auto mesh = test::ball(60);
  GaussArea gauss;
  double sum = 0;
  for (std::size_t t = 0; t < mesh->triangleCount(); ++t) {
    gauss.triangle.push_back(mesh->triangleArea()[t] * (t % 2 == 0 ? 2 : 0));
    sum += gauss.triangle.back();
  }
  const auto density = smoothDensity(*mesh, gauss);
  double after = 0, worst = 0;
  for (std::size_t t = 0; t < density.size(); ++t) {
    after += density[t] * mesh->triangleArea()[t];
    worst = std::max(worst, std::abs(density[t] - 1));
  }
  EXPECT_NEAR(after / sum, 1, 0.01);
  EXPECT_LT(worst, 0.4);  // before: 1 everywhere
}

TEST(SmoothDensity, LeavesCoarseMeshesAlone) {
  const auto mesh = test::cube(1);
  GaussArea gauss;
  gauss.triangle.assign(12, 0.0);
  gauss.triangle[5] = 1;
  const auto density = smoothDensity(*mesh, gauss);
  for (std::size_t t = 0; t < 12; ++t) {
    EXPECT_DOUBLE_EQ(density[t], t == 5 ? 1 / mesh->triangleArea()[5] : 0);
  }
}

}  // namespace
}  // namespace chartflood
