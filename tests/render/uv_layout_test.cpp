#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "render/scene/corner_uv.h"
#include "render/scene/cut_path.h"
#include "render/scene/uv_layout.h"
#include "tests/render/shapes.h"

namespace chartflood {
namespace {

constexpr int kColumns = 6, kRows = 3;

/// Columns 0-2 at 1/10 texture units a square, the others apart from them at 1/30.
std::vector<glm::vec2> twoIslands(const Mesh& mesh) {
  std::vector<glm::vec2> uv;
  for (Index t = 0; t < mesh.triangleCount(); ++t) {
    const bool left = t / 2 % kColumns < 3;
    for (const Index v : mesh.triangles()[t]) {
      const glm::dvec2 p(mesh.positions()[v] * mesh.scale() + mesh.center());
      uv.push_back(left ? glm::vec2(p / 10.0) : glm::vec2(0.5 + p.x / 30, 0.5 + p.y / 30));
    }
  }
  return uv;
}

TEST(UvLayout, FindsIslandsAndTheirScale) {
  const auto mesh = test::plate(kColumns, kRows);
  const UvLayout layout = uvLayout(*mesh, twoIslands(*mesh));
  ASSERT_EQ(layout.firstTriangle.size(), 2u);
  const double diagonal = std::hypot(kColumns, kRows);
  for (Index t = 0; t < mesh->triangleCount(); ++t) {
    const bool left = t / 2 % kColumns < 3;
    EXPECT_EQ(layout.island[t], left ? 0u : 1u);
    EXPECT_NEAR(double{layout.corners[3 * t].z}, (left ? 10 : 30) / diagonal, 1e-5);
  }
  // Around 3 x 3 squares.
  EXPECT_EQ(layout.outlineOf[0].count, 12u);
  EXPECT_EQ(layout.outlineOf[1].count, 12u);
  EXPECT_EQ(layout.outline.size(), 24u);
}

TEST(UvLayout, TrianglesWithoutPlaceBelongToNoIsland) {
  const auto mesh = test::plate(kColumns, kRows);
  std::vector<glm::vec2> uv = twoIslands(*mesh);
  uv[4].y = std::numeric_limits<float>::quiet_NaN();  // one corner is enough
  const UvLayout layout = uvLayout(*mesh, uv);
  EXPECT_EQ(layout.island[1], kNone);
  EXPECT_EQ(layout.corners[3].x, UvLayout::kNoPlace);
  EXPECT_EQ(layout.island[0], 0u);
}

TEST(UvLayout, IslandsWithoutAreaHaveNoScale) {
  const auto mesh = test::plate(2, 1);
  const std::vector<glm::vec2> uv(3 * mesh->triangleCount(), glm::vec2(0.5f));
  const UvLayout layout = uvLayout(*mesh, uv);
  for (const glm::vec3& corner : layout.corners) EXPECT_EQ(corner.z, 0);
}

TEST(UvLayout, ACutIsDrawnOnBothBanksAndNotAsOutline) {
  const auto mesh = test::plate(kColumns, kRows);
  const UvLayout layout = uvLayout(*mesh, twoIslands(*mesh));
  // The border between the islands, as if it were a cut: the lowest edge of it.
  const Index side = layout.outline[0];
  const Index seam = [&] {
    for (const Index s : layout.outline) {
      if (mesh->opposite()[s] != kNone) return s;
    }
    return side;
  }();
  const Index sides[] = {seam};
  const UvLines lines = uvLines(*mesh, layout, measureCuts(*mesh, sides));
  EXPECT_EQ(lines.cuts.size(), 4u);  // two segments
  EXPECT_EQ(lines.outline.size(), 2 * (layout.outline.size() - 2));
  EXPECT_EQ(lines.outlineOf[0].count + lines.outlineOf[1].count, layout.outline.size() - 2);
  // Both banks are as long in their island's own texture units.
  const double first = std::abs(double{lines.cuts[1].w - lines.cuts[0].w});
  const double second = std::abs(double{lines.cuts[3].w - lines.cuts[2].w});
  const double ratio = std::max(first, second) / std::min(first, second);
  EXPECT_NEAR(ratio, 3, 1e-4);
}

TEST(CutPath, LengthsRunOnWhicheverWayTheSidesPoint) {
  const auto mesh = test::plate(kColumns, kRows);
  const auto sideOf = [&](Index from, Index to) {
    for (Index s = 0; s < 3 * mesh->triangleCount(); ++s) {
      if (mesh->sideStart(s) == from && mesh->sideEnd(s) == to) return s;
    }
    return kNone;
  };
  const double unit = 1 / std::hypot(kColumns, kRows);
  const Index row = kColumns + 1;  // inner vertices, where both directions exist
  const Index sides[] = {sideOf(row + 1, row + 2), sideOf(row + 3, row + 2),
                         sideOf(row + 3, row + 4), sideOf(2 * row + 2, 2 * row + 1)};
  for (const Index side : sides) ASSERT_NE(side, kNone);
  const auto edges = measureCuts(*mesh, sides);
  ASSERT_EQ(edges.size(), 4u);
  EXPECT_NEAR(double{edges[0].from}, 0, 1e-6);
  EXPECT_NEAR(double{edges[0].to}, unit, 1e-6);
  EXPECT_NEAR(double{edges[1].from}, 2 * unit, 1e-6);  // against the path
  EXPECT_NEAR(double{edges[1].to}, unit, 1e-6);
  EXPECT_NEAR(double{edges[2].to}, 3 * unit, 1e-6);
  EXPECT_NEAR(double{edges[3].from}, 0, 1e-6);  // a path of its own
}

TEST(CornerUv, TakesEachCornerFromItsChartsVertex) {
  const auto mesh = test::plate(2, 1);
  ChartSet charts;
  Atlas atlas;
  atlas.uv.resize(2);
  CutChart chart;
  chart.surface.meshTriangle = {1, 3};
  chart.surface.triangles = {{0, 1, 2}, {2, 1, 3}};
  chart.surface.positions.resize(4);
  chart.cuts.push_back({CutReason::Tip, {4, 5}, 1});
  chart.cuts.push_back({CutReason::Handle, {9}, 1});
  charts.charts.push_back({});
  charts.charts.push_back(std::move(chart));
  atlas.uv[1] = {{0, 0}, {0.25, 0}, {0, 0.5}, {1, 1}};
  const auto uv = cornerUv(*mesh, charts, atlas);
  ASSERT_EQ(uv.size(), 12u);
  EXPECT_TRUE(std::isnan(uv[0].x));
  EXPECT_EQ(uv[4], glm::vec2(0.25f, 0));
  EXPECT_EQ(uv[9], glm::vec2(0, 0.5f));
  EXPECT_EQ(uv[11], glm::vec2(1, 1));
  EXPECT_EQ(cutSides(charts), (std::vector<Index>{4, 5, 9}));
}

}  // namespace
}  // namespace chartflood
