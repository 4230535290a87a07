#include "render/scene/chart_palette.h"

#include <algorithm>
#include <random>
#include <set>

#include <gtest/gtest.h>

#include "tests/render/shapes.h"

namespace chartflood {
namespace {

const ChartPalette& muted() { return chartPaletteTable()[0]; }

void expectProper(std::span<const Index> color, std::span<const ChartPair> neighbours) {
  for (const auto& [a, b] : neighbours) EXPECT_NE(color[a], color[b]) << a << " and " << b;
}

/// Triangulated grid: degree 6, planar.
std::vector<ChartPair> gridPairs(Index width, Index height) {
  std::vector<ChartPair> pairs;
  for (Index y = 0; y < height; ++y) {
    for (Index x = 0; x < width; ++x) {
      const Index i = y * width + x;
      if (x + 1 < width) pairs.emplace_back(i, i + 1);
      if (y + 1 < height) pairs.emplace_back(i, i + width);
      if (x + 1 < width && y + 1 < height) pairs.emplace_back(i, i + width + 1);
    }
  }
  return pairs;
}

TEST(ChartPalette, NeighboursDifferAndTheReserveStaysUnused) {
  const auto pairs = gridPairs(10, 10);
  const auto color = colorCharts(100, pairs, {}, muted());
  expectProper(color, pairs);
  EXPECT_LT(*std::max_element(color.begin(), color.end()), 9u);
}

TEST(ChartPalette, AHubWithManyNeighboursGetsAUsualColour) {
  // Twelve charts around one: with the least used colour first they show all nine before the hub
  // (the last) is painted, so some must be repainted.
  std::vector<ChartPair> pairs;
  for (Index i = 0; i < 12; ++i) {
    pairs.emplace_back(i, 12);
    if (i + 1 < 12) pairs.emplace_back(i, i + 1);
  }
  const auto color = colorCharts(13, pairs, {}, muted());
  expectProper(color, pairs);
  EXPECT_LT(color[12], 9u);
}

TEST(ChartPalette, TenMutualNeighboursUseTheReserve) {
  std::vector<ChartPair> pairs;
  for (Index a = 0; a < 10; ++a) {
    for (Index b = a + 1; b < 10; ++b) pairs.emplace_back(a, b);
  }
  const auto color = colorCharts(10, pairs, {}, muted());
  expectProper(color, pairs);
  EXPECT_EQ(std::count(color.begin(), color.end(), 9u), 1);
}

TEST(ChartPalette, ChartsKeepTheirColourWhenNeighboursChange) {
  const auto pairs = gridPairs(6, 6);
  const auto before = colorCharts(36, pairs, {}, muted());
  // The same again, and with one chart more that touches two old ones.
  EXPECT_EQ(colorCharts(36, pairs, before, muted()), before);
  auto more = pairs;
  more.emplace_back(0, 36);
  more.emplace_back(1, 36);
  const auto after = colorCharts(37, more, before, muted());
  expectProper(after, more);
  EXPECT_TRUE(std::equal(before.begin(), before.end(), after.begin()));
}

TEST(ChartPalette, OnlyTheClashingChartChanges) {
  const std::vector<Index> before{3, 5, 3};
  const std::vector<ChartPair> pairs{{0, 1}, {0, 2}, {1, 2}};
  const auto after = colorCharts(3, pairs, before, muted());
  EXPECT_EQ(after[0], 3u);
  EXPECT_EQ(after[1], 5u);
  expectProper(after, pairs);
}

TEST(ChartPalette, NeighboursOfALabelling) {
  const auto mesh = test::cube(1);
  // Triangles of a cube, one chart a side of the cube: opposite sides are not neighbours.
  std::vector<Index> label(mesh->faceCount());
  for (Index f = 0; f < label.size(); ++f) label[f] = f / 2;
  const auto pairs = neighbourCharts(*mesh, label);
  EXPECT_EQ(pairs.size(), 12u);
  const std::set<ChartPair> set(pairs.begin(), pairs.end());
  EXPECT_FALSE(set.contains({0, 1}));
  EXPECT_FALSE(set.contains({2, 3}));
  EXPECT_FALSE(set.contains({4, 5}));
  label[0] = kNone;
  label[1] = kNone;
  EXPECT_EQ(neighbourCharts(*mesh, label).size(), 8u);
}

TEST(ChartPalette, NearbyPointsAreTakenForNeighbours) {
  std::vector<glm::dvec3> points;
  for (int i = 0; i < 20; ++i) points.emplace_back(i, 0, 0);
  const auto pairs = nearbyPairs(points);
  const std::set<ChartPair> set(pairs.begin(), pairs.end());
  for (Index i = 0; i + 1 < 20; ++i) EXPECT_TRUE(set.contains({i, i + 1}));
  EXPECT_FALSE(set.contains({0, 19}));
}

/// Charts of so many triangles, one after the other.
std::vector<Index> labelsOf(std::initializer_list<std::pair<Index, int>> runs) {
  std::vector<Index> label;
  for (const auto& [chart, faces] : runs) label.insert(label.end(), faces, chart);
  return label;
}

TEST(InheritedColors, FollowTheChartsWhateverTheirNumbers) {
  const auto mesh = test::plate(30, 1);
  const auto before = labelsOf({{0, 20}, {1, 20}, {2, 20}});
  const auto after = labelsOf({{2, 23}, {0, 17}, {1, 20}});
  const std::vector<Index> old = {5, 3, 7};
  EXPECT_EQ(inheritedColors(*mesh, before, old, after, 3), (std::vector<Index>{3, 7, 5}));
}

TEST(InheritedColors, OneChartMoreIsOneNewColour) {
  const auto mesh = test::plate(30, 1);
  const auto before = labelsOf({{0, 20}, {1, 20}, {2, 20}});
  const auto after = labelsOf({{0, 20}, {1, 12}, {3, 8}, {2, 20}});
  EXPECT_EQ(inheritedColors(*mesh, before, std::vector<Index>{5, 3, 7}, after, 4),
            (std::vector<Index>{5, 3, 7, kNone}));
}

TEST(InheritedColors, OfNewNeighboursTheLargerShareKeepsIt) {
  const auto mesh = test::plate(30, 1);
  const auto before = labelsOf({{0, 20}, {1, 10}, {2, 30}});
  const auto after = labelsOf({{0, 25}, {2, 35}});
  EXPECT_EQ(inheritedColors(*mesh, before, std::vector<Index>{5, 3, 5}, after, 3),
            (std::vector<Index>{kNone, kNone, 5}));
}

}  // namespace
}  // namespace chartflood
