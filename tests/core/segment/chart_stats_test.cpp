// Figures of charts on shapes whose charts are known: core/charts/chart_stats, chart_areas.

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/charts/chart_stats.h"
#include "core/gauss/compute_gauss_area.h"
#include "core/segment/parts/chart_areas.h"
#include "tests/support/test_meshes.h"

namespace chartflood {
namespace {

Segmentation labelled(const Mesh& mesh, std::vector<Index> label, std::size_t charts) {
  Segmentation s;
  s.chartCount = charts;
  s.seeds.assign(charts, 0);
  const GaussArea gauss = computeGaussArea(mesh, 45);
  s.areas = chartAreas(mesh, gauss, faceGaussArea(mesh, gauss), label, charts);
  s.label = std::move(label);
  return s;
}

TEST(ChartStats, CubeFacesAreDisks) {
  const auto cube = test::quadCube();
  const ChartStats stats = measureCharts(*cube, labelled(*cube, {0, 1, 2, 3, 4, 5}, 6));
  for (const ChartFigures& c : stats.charts) {
    EXPECT_TRUE(c.disk);
    EXPECT_EQ(c.faces, 1u);
    EXPECT_NEAR(c.area, 1, 1e-12);
    EXPECT_NEAR(c.perimeter, 4, 1e-12);
  }
  EXPECT_NEAR(stats.seamLength, 12, 1e-12);
  EXPECT_NEAR(stats.onSeams, 4 * std::numbers::pi, 1e-9);
  EXPECT_FALSE(stats.balanceDefined);
  EXPECT_EQ(stats.stdOverMean(), 0);
}

TEST(ChartStats, WholeCubeIsClosed) {
  const auto cube = test::quadCube();
  const ChartStats stats = measureCharts(*cube, labelled(*cube, std::vector<Index>(6, 0), 1));
  EXPECT_EQ(stats.charts[0].euler, 2);
  EXPECT_EQ(stats.charts[0].boundaryLoops, 0u);
  EXPECT_FALSE(stats.charts[0].disk);
  EXPECT_NEAR(stats.charts[0].gaussArea, 4 * std::numbers::pi, 1e-9);
  EXPECT_EQ(stats.seamLength, 0);
}

TEST(ChartStats, BeltOfACubeIsARing) {
  const auto cube = test::quadCube();
  // Faces 0 and 1 are the ends; the other four form a belt.
  const ChartStats stats = measureCharts(*cube, labelled(*cube, {0, 1, 2, 2, 2, 2}, 3));
  EXPECT_EQ(stats.charts[2].euler, 0);
  EXPECT_EQ(stats.charts[2].boundaryLoops, 2u);
  EXPECT_FALSE(stats.charts[2].disk);
  EXPECT_TRUE(stats.charts[2].connected);
}

TEST(ChartStats, TorusHasNoDisk) {
  const auto torus = test::sampleMesh("torus", 1000);
  const ChartStats stats =
      measureCharts(*torus, labelled(*torus, std::vector<Index>(torus->faceCount(), 0), 1));
  EXPECT_EQ(stats.charts[0].euler, 0);
  EXPECT_EQ(stats.charts[0].boundaryLoops, 0u);
}

TEST(ChartStats, PiecesAreSeen) {
  const auto cube = test::quadCube();
  const ChartStats stats = measureCharts(*cube, labelled(*cube, {0, 0, 1, 1, 1, 1}, 2));
  EXPECT_FALSE(stats.charts[0].connected);
  EXPECT_FALSE(stats.charts[0].disk);
}

TEST(ChartStats, FreeFacesAreLeftOut) {
  const auto cube = test::quadCube();
  const ChartStats stats =
      measureCharts(*cube, labelled(*cube, {0, kNone, kNone, kNone, 0, kNone}, 1));
  EXPECT_EQ(stats.charts[0].faces, 2u);
  EXPECT_TRUE(stats.charts[0].disk);
  EXPECT_EQ(stats.seamLength, 0);
}

TEST(ChartAreas, AddUpToTheTotal) {
  const auto mesh = test::sampleMesh("rocket", 5000);
  const GaussArea gauss = computeGaussArea(*mesh, 30);
  const auto face = faceGaussArea(*mesh, gauss);
  std::vector<Index> label(mesh->faceCount());
  for (Index f = 0; f < label.size(); ++f) label[f] = f % 7 == 6 ? kNone : f / 50 % 6;
  const ChartAreas areas = chartAreas(*mesh, gauss, face, label, 6);
  double sum = areas.onSeams;
  for (const double a : areas.gaussArea) sum += a;
  EXPECT_NEAR(sum, gauss.total(), 1e-9 * gauss.total());
}

}  // namespace
}  // namespace chartflood
