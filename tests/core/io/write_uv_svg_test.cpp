// The layout as SVG: the same frame as the texture, one closed path a chart, numbers inside.

#include "core/io/write/write_uv_svg.h"

#include <gtest/gtest.h>

#include <cmath>
#include <regex>
#include <set>

#include "core/charts/chart_surface.h"
#include "core/io/write/label_point.h"
#include "export_support.h"
#include "tests/support/test_meshes.h"

namespace chartflood::test {
namespace {

struct Group {
  std::string id, fill, path, number{};
  glm::dvec2 at{0};  ///< the number's baseline
  double height = 0;
};

std::vector<Group> groupsOf(const std::string& svg) {
  std::vector<Group> groups;
  const std::regex pattern(
      R"re(<g id="(chart_[0-9]+)" fill="([^"]*)">\n<path [^>]* ?d="([^"]*)"/>\n)re"
      R"re((?:<text [^>]*font-size="([^"]*)" x="([^"]*)" y="([^"]*)">([0-9]+)</text>\n)?</g>\n)re");
  for (std::sregex_iterator at(svg.begin(), svg.end(), pattern), end; at != end; ++at) {
    Group group{(*at)[1], (*at)[2], (*at)[3], (*at)[7]};
    if ((*at)[7].matched) {
      group.height = std::stod((*at)[4]);
      group.at = {std::stod((*at)[5]), std::stod((*at)[6])};
    }
    groups.push_back(group);
  }
  return groups;
}

/// The polygons of a path of M, L and Z.
Outline polygonsOf(const std::string& path) {
  Outline polygons;
  const std::regex pattern("([ML])([-0-9.e]+) ([-0-9.e]+)(Z?)");
  for (std::sregex_iterator at(path.begin(), path.end(), pattern), end; at != end; ++at) {
    if ((*at)[1] == "M") polygons.emplace_back();
    polygons.back().emplace_back(std::stod((*at)[2]), std::stod((*at)[3]));
  }
  return polygons;
}

double areaOf(const Outline& polygons) {
  double twice = 0;
  for (const auto& p : polygons) {
    for (std::size_t i = 0; i < p.size(); ++i) {
      const glm::dvec2 a = p[i], b = p[(i + 1) % p.size()];
      twice += a.x * b.y - b.x * a.y;
    }
  }
  return std::fabs(twice) / 2;
}

bool inside(const Outline& polygons, const glm::dvec2& p) {
  bool odd = false;
  for (const auto& loop : polygons) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const glm::dvec2 a = loop[i], b = loop[(i + 1) % loop.size()];
      if ((a.y <= p.y) == (b.y <= p.y)) continue;
      if (a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y) > p.x) odd = !odd;
    }
  }
  return odd;
}

TEST(WriteUvSvg, HasOneClosedPathAChartInTheFrameOfTheTexture) {
  const Charted charted = inPatches(sampleMesh("sphere", 2000), 50);
  const std::string svg = uvSvgText(charted.view(), {});
  EXPECT_NE(svg.find("width=\"512\" height=\"512\" viewBox=\"0 0 512 512\""), std::string::npos);
  const std::vector<Group> groups = groupsOf(svg);
  ASSERT_EQ(groups.size(), charted.charts.charts.size());
  for (std::size_t c = 0; c < groups.size(); ++c) {
    EXPECT_EQ(groups[c].id, chartName(static_cast<Index>(c)));
    const Outline shape = polygonsOf(groups[c].path);
    EXPECT_EQ(shape.size(), boundaryLoops(charted.charts.charts[c].surface).size());
    EXPECT_EQ(std::count(groups[c].path.begin(), groups[c].path.end(), 'Z'),
              static_cast<long>(shape.size()));
    // The area that the outline encloses is that of the triangles.
    double area = 0;
    const auto& uv = charted.atlas.uv[c];
    for (const auto& t : charted.charts.charts[c].surface.triangles) {
      const glm::dvec2 a = uv[t[1]] - uv[t[0]], b = uv[t[2]] - uv[t[0]];
      area += 0.5 * (a.x * b.y - a.y * b.x);
    }
    EXPECT_NEAR(areaOf(shape), std::fabs(area) * 512 * 512, 1.0);
  }
}

TEST(WriteUvSvg, PointsUpwards) {
  const auto mesh = meshOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
  Charted charted = chartedMesh(mesh, {0});
  charted.atlas.uv[0] = {{0, 0}, {1, 0}, {0.25, 0.75}};
  const auto groups = groupsOf(uvSvgText(charted.view(), {.size = 100}));
  ASSERT_EQ(groups.size(), 1u);
  EXPECT_EQ(groups[0].path, "M0 100L100 100L25 25Z");
}

TEST(WriteUvSvg, NumbersStandInTheirCharts) {
  const Charted charted = inPatches(sampleMesh("rocket", 4000), 120);
  std::size_t seen = 0;
  for (const Group& group : groupsOf(uvSvgText(charted.view(), {}))) {
    if (group.number.empty()) continue;
    ++seen;
    EXPECT_EQ(chartName(static_cast<Index>(std::stoul(group.number))), group.id);
    const glm::dvec2 middle(group.at.x, group.at.y - 0.36 * group.height);
    EXPECT_TRUE(inside(polygonsOf(group.path), middle)) << group.id;
  }
  EXPECT_GT(seen, charted.charts.charts.size() / 2);
  EXPECT_EQ(uvSvgText(charted.view(), {.numbers = false}).find("<text"), std::string::npos);
}

TEST(WriteUvSvg, TakesColoursAndLeavesThemOut) {
  const Charted charted = inPatches(quadCube(), 2);
  const std::vector<std::uint32_t> colors{0x0A0B0C, 0xFFFFFF};
  const std::string svg = uvSvgText(charted.view(), {.colors = colors});
  const auto filled = groupsOf(svg);
  EXPECT_NE(svg.find("<text fill=\"#ffffff\""), std::string::npos) << "white on black";
  EXPECT_NE(svg.find("<text fill=\"#000000\""), std::string::npos) << "black on white";
  EXPECT_EQ(filled[0].fill, "#0a0b0c");
  EXPECT_EQ(filled[1].fill, "#ffffff");
  EXPECT_EQ(groupsOf(uvSvgText(charted.view(), {.fill = false}))[0].fill, "none");
}

TEST(WriteUvSvg, LeavesChartsOutThatAreNotLaidFlat) {
  Charted charted = inPatches(quadCube(), 2);
  charted.atlas.uv[0].clear();
  const auto groups = groupsOf(uvSvgText(charted.view(), {}));
  ASSERT_EQ(groups.size(), charted.charts.charts.size() - 1);
  EXPECT_EQ(groups[0].id, "chart_001");
}

TEST(LabelPoint, LiesInsideAndFarFromTheOutline) {
  // The letter C: its middle is outside.
  const Outline c{{{0, 0}, {10, 0}, {10, 3}, {2, 3}, {2, 7}, {10, 7}, {10, 10}, {0, 10}}};
  const LabelPoint inC = labelPoint(c);
  EXPECT_TRUE(inside(c, inC.at));
  EXPECT_GT(inC.room, 1.2);
  // A ring: the hole is outside.
  const Outline ring{{{0, 0}, {10, 0}, {10, 10}, {0, 10}}, {{3, 3}, {3, 8}, {8, 8}, {8, 3}}};
  EXPECT_TRUE(inside(ring, labelPoint(ring).at));
  const LabelPoint square = labelPoint({{{0, 0}, {1, 0}, {1, 1}, {0, 1}}});
  EXPECT_NEAR(square.room, 0.5, 1e-9);
  EXPECT_EQ(labelPoint({{{0, 0}, {1, 1}, {2, 2}}}).room, 0);
  EXPECT_EQ(labelPoint({}).room, 0);
}

}  // namespace
}  // namespace chartflood::test
