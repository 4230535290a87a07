// Known Gauss areas and invariances: core/gauss/compute_gauss_area (paper section 3.2).

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <string>

#include <glm/glm.hpp>
#include <gtest/gtest.h>

#include "core/gauss/compute_gauss_area.h"
#include "core/gauss/sector_normals.h"
#include "core/gauss/sharp_edges.h"
#include "tests/support/test_meshes.h"

namespace chartflood {
namespace {

class AtThreeResolutions : public testing::TestWithParam<std::size_t> {
 protected:
  GaussArea area(const std::string& sample, double sharpAngle) const {
    return computeGaussArea(*test::sampleMesh(sample, GetParam()), sharpAngle);
  }
};
INSTANTIATE_TEST_SUITE_P(Triangles, AtThreeResolutions, testing::Values(1500, 6000, 24000));

TEST_P(AtThreeResolutions, SphereIsAllFaces) {
  for (const double angle : {45.0, 180.0}) {
    const GaussArea g = area("sphere", angle);
    EXPECT_NEAR(g.triangleTotal, 4 * std::numbers::pi, 1e-6);
    EXPECT_EQ(g.edgeTotal, 0);
    EXPECT_EQ(g.cornerTotal, 0);
    EXPECT_NEAR(g.signedTotal, 4 * std::numbers::pi, 1e-6);
  }
}

TEST_P(AtThreeResolutions, CubeIsAllCorners) {
  const GaussArea g = area("cube", 45);
  ASSERT_EQ(g.corners.size(), 8u);
  for (const double corner : g.corner) EXPECT_NEAR(corner, std::numbers::pi / 2, 1e-9);
  EXPECT_NEAR(g.edgeTotal, 0, 1e-9);
  EXPECT_NEAR(g.triangleTotal, 0, 1e-9);
  const GaussArea smooth = area("cube", 180);
  EXPECT_NEAR(smooth.triangleTotal, 4 * std::numbers::pi, 1e-6);
  EXPECT_TRUE(smooth.sharpEdges.empty());
}

TEST_P(AtThreeResolutions, CylinderIsAllRims) {
  const GaussArea g = area("cylinder", 45);
  EXPECT_NEAR(g.edgeTotal, 4 * std::numbers::pi, 1e-6);
  EXPECT_NEAR(g.triangleTotal, 0, 1e-6);
  EXPECT_NEAR(g.cornerTotal, 0, 1e-9);
}

TEST_P(AtThreeResolutions, TubeAndPlaneHaveNone) {
  EXPECT_NEAR(area("tube", 45).total(), 0, 1e-6);
  EXPECT_NEAR(area("plane", 45).total(), 0, 1e-9);
  EXPECT_EQ(area("plane", 45).maxCurvature, 1);
}

TEST_P(AtThreeResolutions, TorusIsTwiceASphereAndCancels) {
  const GaussArea g = area("torus", 45);
  EXPECT_NEAR(g.total(), 8 * std::numbers::pi, 0.02 * 8 * std::numbers::pi);
  EXPECT_NEAR(g.signedTotal, 0, 1e-6);
}

TEST_P(AtThreeResolutions, LBlockIsSixPiOnCorners) {
  const GaussArea g = area("l-block", 45);
  EXPECT_NEAR(g.cornerTotal, 6 * std::numbers::pi, 1e-9);
  EXPECT_NEAR(g.edgeTotal, 0, 1e-9);
  EXPECT_NEAR(g.triangleTotal, 0, 1e-9);
  EXPECT_NEAR(g.signedTotal, 4 * std::numbers::pi, 1e-9);
}

TEST(GaussArea, ConeConcentratesAtTheApex) {
  const auto mesh = test::sampleMesh("cone", 20000);
  const GaussArea g = computeGaussArea(*mesh, 45);
  double low = 1e9, high = -1e9, radius = 0;
  for (const auto& p : mesh->input().positions) {
    low = std::min(low, p.y);
    high = std::max(high, p.y);
    radius = std::max(radius, std::abs(p.x));
  }
  const double exact = 2 * std::numbers::pi * (1 - std::sin(std::atan(radius / (high - low))));
  EXPECT_NEAR(g.total(), exact, 0.01 * exact);
}

class Invariance : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Samples, Invariance,
                         testing::Values("rocket", "l-block", "double-torus", "bumps"));

TEST_P(Invariance, SignedTotalIsAWholeNumberOfSpheresWhenClosed) {
  const auto mesh = test::sampleMesh(GetParam(), 6000);
  for (const double angle : {20.0, 45.0, 180.0}) {
    const GaussArea g = computeGaussArea(*mesh, angle);
    const double degree = g.signedTotal / (4 * std::numbers::pi);
    if (mesh->closed()) {
      EXPECT_NEAR(degree, std::round(degree), 1e-6) << angle;
    }
    for (const double a : g.triangle) {
      ASSERT_GE(a, 0);
      ASSERT_LE(a, 2 * std::numbers::pi);
    }
    for (const double a : g.edge) {
      ASSERT_GE(a, 0);
      ASSERT_LE(a, 2 * std::numbers::pi);
    }
  }
}

TEST_P(Invariance, PowersOfTwoChangeNothing) {
  const auto mesh = test::sampleMesh(GetParam(), 3000);
  InputMesh scaled = test::copyInput(*mesh);
  for (auto& p : scaled.positions) p *= 4096.0;
  const GaussArea a = computeGaussArea(*mesh, 45);
  const GaussArea b = computeGaussArea(*test::rebuild(std::move(scaled)), 45);
  EXPECT_EQ(a.triangle, b.triangle);
  EXPECT_EQ(a.edge, b.edge);
  EXPECT_EQ(a.corner, b.corner);
}

TEST_P(Invariance, RotationAndFaceOrderKeepTheTotal) {
  const auto mesh = test::sampleMesh(GetParam(), 3000);
  InputMesh turned = test::copyInput(*mesh);
  ASSERT_TRUE(turned.faceStart.empty() || mesh->facesAreTriangles());
  const double c = std::cos(0.7), s = std::sin(0.7);
  for (auto& p : turned.positions) p = {c * p.x - s * p.y, s * p.x + c * p.y, p.z + 10};
  // Faces backwards, each starting at its second corner.
  InputMesh shuffled = turned;
  const std::size_t faces = turned.faceCount();
  shuffled.faceStart.clear();
  shuffled.corners.clear();
  for (std::size_t f = faces; f-- > 0;) {
    const auto corners = turned.face(f);
    ASSERT_EQ(corners.size(), 3u);
    for (const int i : {1, 2, 0}) shuffled.corners.push_back(corners[static_cast<std::size_t>(i)]);
  }
  const GaussArea a = computeGaussArea(*mesh, 45);
  const GaussArea b = computeGaussArea(*test::rebuild(std::move(shuffled)), 45);
  EXPECT_NEAR(a.total(), b.total(), 1e-9 * a.total());
  EXPECT_NEAR(a.cornerTotal, b.cornerTotal, 1e-9 * a.total());
}

TEST(GaussArea, LargerAnglesMoveAreaToFaces) {
  const auto mesh = test::sampleMesh("rocket", 8000);
  const GaussArea sharp = computeGaussArea(*mesh, 20), smooth = computeGaussArea(*mesh, 180);
  EXPECT_GT(sharp.edgeTotal + sharp.cornerTotal, 0);
  EXPECT_EQ(smooth.edgeTotal + smooth.cornerTotal, 0);
  EXPECT_GT(smooth.triangleTotal, sharp.triangleTotal);
}

TEST(GaussArea, PolygonsCountTheirDiagonals) {
  const auto cube = test::quadCube();
  const GaussArea g = computeGaussArea(*cube, 180);
  const FaceValues face = faceGaussArea(*cube, g);
  ASSERT_EQ(face.size(), 6u);
  EXPECT_NEAR(std::accumulate(face.begin(), face.end(), 0.0), 4 * std::numbers::pi, 1e-6);
}

TEST(GaussArea, BadGeometryStaysFinite) {
  const auto flat = test::meshOf({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 1, 0}, {1, 0, 0}},
                                 {{0, 1, 3}, {1, 2, 3}, {0, 2, 1}, {4, 1, 0}});
  const GaussArea g = computeGaussArea(*flat, 45);
  EXPECT_TRUE(std::isfinite(g.total()));
  EXPECT_TRUE(std::isfinite(g.maxCurvature));
}

TEST(SharpEdges, ThresholdIsExclusive) {
  const auto cube = test::quadCube();
  const auto count = [&](double angle) {
    const auto sharp = findSharpSides(*cube, angle);
    return std::count(sharp.begin(), sharp.end(), 1);
  };
  EXPECT_EQ(count(89.999), 24);
  EXPECT_EQ(count(90), 0);
  EXPECT_EQ(count(0), 24);  // diagonals of flat quads are not folded
}

TEST(SectorNormals, CubeCornersHaveThree) {
  const auto cube = test::quadCube();
  const SectorNormals n = computeSectorNormals(*cube, findSharpSides(*cube, 45));
  ASSERT_EQ(n.splits.size(), 8u);
  for (const auto& split : n.splits) {
    EXPECT_EQ(split.sectorCount, 3u);
    EXPECT_TRUE(split.interior);
  }
}

TEST(SectorNormals, MaxWeightsAreExactOnASphere) {
  // Max's weights give the exact normal at any vertex of a sphere, however uneven its triangles.
  const auto mesh = test::sampleMesh("sphere", 2000);
  InputMesh uneven = test::copyInput(*mesh);
  for (auto& p : uneven.positions)
    p = glm::normalize(p + glm::dvec3(0.3 * p.x * p.y, 0, 0.2 * p.x));
  const auto sphere = test::rebuild(std::move(uneven));
  const SectorNormals n = computeSectorNormals(*sphere, findSharpSides(*sphere, 180));
  for (Index v = 0; v < sphere->vertexCount(); ++v) {
    const glm::dvec3 exact = glm::normalize(sphere->input().positions[sphere->inputVertex(v)]);
    ASSERT_LT(glm::length(n.vertex[v] - exact), 1e-9);
  }
}

}  // namespace
}  // namespace chartflood
