// Charts of thin triangles: rods, needles, strips and fans are laid flat without stretch, and a
// sliver in an ordinary chart does no harm.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "core/charts/chart_surface.h"
#include "core/charts/cut_charts.h"
#include "core/param/chart_shape.h"
#include "core/param/cone_cuts.h"
#include "core/param/stretch.h"
#include "core/param/unfold.h"
#include "core/session/session.h"
#include "tests/core/param/param_support.h"
#include "tests/core/param/thin_bodies.h"

namespace chartflood {
namespace {

const UnwrapOptions kFreeWithSlits{UnwrapOptions::Boundary::Free, 1.5};

/// L2 stretch of a chart (Sander 2001) in long numbers, with nothing of the program.
double stretchOf(const ChartSurface& s, const std::vector<glm::dvec2>& uv) {
  using Real = long double;
  Real space = 0, plane = 0, squares = 0;
  for (const auto& t : s.triangles) {
    Real e1[3], e2[3], f1[2], f2[2];
    for (int i = 0; i < 3; ++i) {
      e1[i] = Real(s.positions[t[1]][i]) - s.positions[t[0]][i];
      e2[i] = Real(s.positions[t[2]][i]) - s.positions[t[0]][i];
    }
    for (int i = 0; i < 2; ++i) {
      f1[i] = Real(uv[t[1]][i]) - uv[t[0]][i];
      f2[i] = Real(uv[t[2]][i]) - uv[t[0]][i];
    }
    const Real n[3] = {e1[1] * e2[2] - e1[2] * e2[1], e1[2] * e2[0] - e1[0] * e2[2],
                       e1[0] * e2[1] - e1[1] * e2[0]};
    const Real area = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]) / 2;
    const Real det = f1[0] * f2[1] - f1[1] * f2[0];
    space += area;
    plane += std::abs(det) / 2;
    for (int i = 0; i < 3; ++i) {
      const Real u = (e1[i] * f2[1] - e2[i] * f1[1]) / det;
      const Real v = (e2[i] * f1[0] - e1[i] * f2[0]) / det;
      squares += area * (u * u + v * v) / 2;
    }
  }
  return static_cast<double>(std::sqrt(squares / space * plane / space));
}

UnwrapResult unwrapInto(const std::shared_ptr<const Mesh>& mesh, int charts) {
  Session session(Session::Worker::Inline);
  session.openMesh(mesh);
  Document document = session.document();
  document.parameters.charts = charts;
  session.setDocument(document);
  session.step(StepUnit::Converged);
  Progress progress;
  const auto cut = cutCharts(*mesh, *session.results()->segmentation, {}, progress);
  return unwrapCharts(*mesh, cut, kFreeWithSlits, progress);
}

/// Every chart isometric by the program's figures and by ours, one-to-one, nothing left out.
void expectIsometric(const std::shared_ptr<const Mesh>& mesh) {
  for (const int charts : {1, 3, 8, 20}) {
    SCOPED_TRACE("K = " + std::to_string(charts));
    const UnwrapResult result = unwrapInto(mesh, charts);
    std::size_t triangles = 0;
    for (std::size_t c = 0; c < result.unwrap->charts.size(); ++c) {
      SCOPED_TRACE("chart " + std::to_string(c));
      const ChartUv& chart = result.unwrap->charts[c];
      const ChartSurface& surface = result.charts->charts[c].surface;
      ASSERT_EQ(chart.problem, "");
      EXPECT_LE(chart.distortion.l2, 1.001);
      EXPECT_LE(stretchOf(surface, chart.uv), 1.001);
      EXPECT_EQ(chart.distortion.flipped, 0u);
      EXPECT_EQ(test::badTriangles(surface, chart.uv), 0u);
      EXPECT_EQ(test::crossings(surface, chart.uv), 0u);
      triangles += surface.triangleCount();
    }
    EXPECT_EQ(triangles, mesh->triangleCount());
  }
}

class ThinBodies : public testing::TestWithParam<std::tuple<double, Index>> {
 protected:
  double aspect() const { return std::get<0>(GetParam()); }
  Index sides() const { return std::get<1>(GetParam()); }
};
std::string nameOf(const testing::TestParamInfo<std::tuple<double, Index>>& instance) {
  const auto [aspect, sides] = instance.param;
  return "Aspect1e" + std::to_string(std::lround(std::log10(aspect))) + "Sides" +
         std::to_string(sides);
}
INSTANTIATE_TEST_SUITE_P(Sizes, ThinBodies,
                         testing::Combine(testing::Values(1e2, 1e4, 1e6),
                                          testing::Values(3u, 32u, 500u)),
                         nameOf);
// Triangles of 1e-9 and below: with more sides they would be thinner than doubles can tell.
INSTANTIATE_TEST_SUITE_P(Thinnest, ThinBodies,
                         testing::Combine(testing::Values(1e9), testing::Values(3u, 32u)), nameOf);

TEST_P(ThinBodies, Rods) {
  for (const bool closed : {false, true}) {
    SCOPED_TRACE(closed);
    expectIsometric(test::thinBody({.sides = sides(), .length = aspect(), .closed = closed}));
  }
}

TEST_P(ThinBodies, RodsInPieces) {
  for (const bool closed : {false, true}) {
    SCOPED_TRACE(closed);
    expectIsometric(
        test::thinBody({.sides = sides(), .length = aspect(), .rings = 4, .closed = closed}));
  }
}

TEST_P(ThinBodies, Frusta) {
  for (const bool closed : {false, true}) {
    SCOPED_TRACE(closed);
    expectIsometric(
        test::thinBody({.sides = sides(), .length = aspect(), .tip = 0.02, .closed = closed}));
  }
}

TEST_P(ThinBodies, Cones) {
  for (const bool closed : {false, true}) {
    SCOPED_TRACE(closed);
    expectIsometric(
        test::thinBody({.sides = sides(), .length = aspect(), .tip = 0, .closed = closed}));
  }
}

TEST_P(ThinBodies, StripsAndFans) {
  expectIsometric(test::thinStrip(sides(), aspect()));
  expectIsometric(test::thinStrip(sides(), 1 / aspect()));
  expectIsometric(test::thinFan(sides(), 1 / aspect()));
}

TEST(Thin, KnownCases) {
  expectIsometric(test::thinStrip(1, 10000));
  expectIsometric(test::thinFan(400, 1e-4));
  expectIsometric(test::thinBody({.sides = 64, .length = 500, .closed = true}));
  expectIsometric(test::thinBody({.sides = 64, .length = 1000, .closed = true}));
  expectIsometric(test::thinBody({.sides = 500, .length = 2.5, .tip = 0.01, .closed = true}));
}

TEST(Thin, StretchOfASliverIsExact) {
  for (const double height : {1e-3, 1e-6, 1e-9}) {
    // Far from the origin, tilted; half as wide in the plane.
    const glm::dvec3 at(0.3, -0.4, 0.2), x(0.48, 0.64, 0.6), y(-0.8, 0.6, 0);
    ChartSurface s;
    s.meshTriangle = {0};
    s.triangles = {{0, 1, 2}};
    s.opposite = {kNone, kNone, kNone};
    s.meshVertex = {0, 1, 2};
    s.positions = {at, at + x, at + 0.3 * x + height * y};
    const auto same = triangleDistortion(s, std::vector<glm::dvec2>{{0, 0}, {1, 0}, {0.3, height}});
    EXPECT_NEAR(same[0].l2, 1, 1e-6);
    EXPECT_NEAR(same[0].angle, 1, 1e-3);
    const auto half =
        triangleDistortion(s, std::vector<glm::dvec2>{{0, 0}, {1, 0}, {0.3, height / 2}});
    EXPECT_NEAR(half[0].l2, std::sqrt((1 + 4) / 2.0 / 2), 1e-6);
    EXPECT_NEAR(half[0].angle, 2, 1e-3);
  }
}

TEST(Thin, TrianglesWithoutAreaAreCountedAndDoNotWeigh) {
  // The middle of the side between the two triangles is a corner of a third one without area.
  const auto mesh = test::meshOf({{0, 0, 0}, {2, 0, 0}, {1, 1, 0}, {1, 0, 0}, {1, -1, 0}},
                                 {{0, 3, 2}, {3, 1, 2}, {0, 1, 3}, {0, 4, 1}});
  const UnwrapResult result = test::unwrapWhole(*mesh, kFreeWithSlits);
  const ChartUv& chart = result.unwrap->charts[0];
  ASSERT_EQ(chart.problem, "");
  EXPECT_EQ(chart.distortion.shapeless, 1u);
  EXPECT_NEAR(chart.distortion.l2, 1, 1e-4);
  EXPECT_EQ(test::badTriangles(result.charts->charts[0].surface, chart.uv), 0u);
}

/// A hill, with a vertex more in each of some triangles: `height` above a side, near its end.
std::shared_ptr<const Mesh> hillWithSlivers(double height) {
  const auto hill = test::surfaceOver(24, 24, false, [](double u, double v) {
    return glm::dvec3(u, v, 0.25 * std::sin(std::numbers::pi * u) * std::sin(std::numbers::pi * v));
  });
  std::vector<glm::dvec3> positions(hill->positions().begin(), hill->positions().end());
  test::Polygons faces;
  for (Index t = 0; t < hill->triangleCount(); ++t) {
    const auto& v = hill->triangles()[t];
    if (height <= 0 || t % 7 != 3) {
      faces.push_back({v[0], v[1], v[2]});
      continue;
    }
    const auto tip = static_cast<Index>(positions.size());
    positions.push_back(positions[v[0]] + 0.0005 * (positions[v[1]] - positions[v[0]]) +
                        height * (positions[v[2]] - positions[v[0]]));
    for (int i = 0; i < 3; ++i) faces.push_back({v[i], v[(i + 1) % 3], tip});
  }
  return test::meshOf(std::move(positions), faces);
}

TEST(Thin, SliversInACurvedChartDoNoHarm) {
  const UnwrapResult smooth = test::unwrapWhole(*hillWithSlivers(0), kFreeWithSlits);
  const double without = smooth.unwrap->charts[0].distortion.l2;
  for (const double height : {1e-5, 1e-7, 1e-10}) {
    SCOPED_TRACE(height);
    const UnwrapResult result = test::unwrapWhole(*hillWithSlivers(height), kFreeWithSlits);
    const ChartUv& chart = result.unwrap->charts[0];
    ASSERT_EQ(chart.problem, "");
    EXPECT_NEAR(chart.distortion.l2, without, 1e-4);
    EXPECT_LT(chart.distortion.linf, 2) << "a sliver would be sheared by tens if its foot moved";
    EXPECT_NEAR(stretchOf(result.charts->charts[0].surface, chart.uv), without, 1e-4);
    EXPECT_EQ(test::badTriangles(result.charts->charts[0].surface, chart.uv), 0u);
    EXPECT_EQ(test::crossings(result.charts->charts[0].surface, chart.uv), 0u);
  }
}

TEST(Thin, UnfoldingKeepsLengthsAndRefusesWhatIsCurved) {
  const auto strip = test::surfaceOver(30, 6, false, [](double u, double v) {
    return glm::dvec3(std::cos(3 * u), std::sin(3 * u), v);
  });
  const CutChart flat = test::wholeChart(*strip);
  const auto uv = unfold(flat.surface);
  ASSERT_EQ(uv.size(), flat.surface.vertexCount());
  for (Index side = 0; side < flat.surface.opposite.size(); ++side) {
    const glm::dvec2 way = uv[flat.surface.sideEnd(side)] - uv[flat.surface.sideStart(side)];
    EXPECT_NEAR(glm::length(way), sideLength(flat.surface, side), 1e-12);
  }
  const CutChart hill = test::wholeChart(*hillWithSlivers(0));
  EXPECT_TRUE(unfold(hill.surface).empty());
}

TEST(Thin, ConesAndRimsAreOpened) {
  CutChart cone = test::wholeChart(*test::thinBody({.sides = 20, .length = 50, .tip = 0}));
  ASSERT_TRUE(openCones(cone, 0.01));
  ASSERT_EQ(cone.cuts.size(), 1u) << "one slit to the tip";
  EXPECT_EQ(cone.cuts[0].sides.size(), 1u);
  EXPECT_TRUE(cone.disk());
  EXPECT_FALSE(openCones(cone, 1)) << "nothing is left to open";
  // One end closed: all around its rim but for the last edge, and one way there.
  const auto open = test::thinBody({.sides = 20, .length = 50});
  InputMesh input = test::copyInput(*open);
  for (Index i = 0; i < 20; ++i) input.corners.push_back(19 - i);
  input.faceStart.push_back(input.corners.size());
  const CutChart cup = test::wholeChart(*test::rebuild(std::move(input)));
  ASSERT_TRUE(cup.disk());
  CutChart tried = cup;
  EXPECT_FALSE(openCones(tried, 1)) << "the way is longer than the rim";
  EXPECT_TRUE(tried.cuts.empty());
  ASSERT_TRUE(openCones(tried, 20));
  std::size_t edges = 0;
  for (const Cut& cut : tried.cuts) edges += cut.sides.size();
  EXPECT_EQ(edges, 20u);
  EXPECT_TRUE(tried.disk());
}

TEST(Thin, WithoutReliefNothingIsCut) {
  const auto mesh = test::thinBody({.sides = 20, .length = 50, .tip = 0});
  const UnwrapResult result = test::unwrapWhole(*mesh, {UnwrapOptions::Boundary::Free, 0});
  EXPECT_TRUE(result.charts->charts[0].cuts.empty());
  EXPECT_EQ(test::badTriangles(result.charts->charts[0].surface, result.unwrap->charts[0].uv), 0u);
}

}  // namespace
}  // namespace chartflood
