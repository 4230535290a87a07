// Charts laid flat: known answers, and what must hold of every chart.

#include "core/param/unwrap_charts.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

#include <glm/geometric.hpp>

#include "core/base/parallel.h"
#include "core/charts/chart_surface.h"
#include "core/param/chart_shape.h"
#include "core/param/circle_map.h"
#include "core/param/free_start.h"
#include "core/param/isometric_map.h"
#include "core/param/stretch.h"
#include "tests/core/param/param_support.h"

namespace chartflood {
namespace {

constexpr double kPi = std::numbers::pi;
const UnwrapOptions kFree{UnwrapOptions::Boundary::Free, 0};
const UnwrapOptions kCircle{UnwrapOptions::Boundary::Circle, 0};

double l2Of(const ChartSurface& surface, const std::vector<glm::dvec2>& uv) {
  return chartDistortion(surface, triangleDistortion(surface, uv)).l2;
}

const ChartUv& only(const UnwrapResult& result) { return result.unwrap->charts.front(); }
const ChartSurface& surfaceOf(const UnwrapResult& result) {
  return result.charts->charts[0].surface;
}

void expectSound(const UnwrapResult& result) {
  ASSERT_EQ(only(result).problem, "");
  test::expectOneToOne(surfaceOf(result), only(result).uv);
  EXPECT_EQ(only(result).distortion.flipped, 0u);
  for (const auto* values :
       {&result.unwrap->stretch, &result.unwrap->area, &result.unwrap->angle}) {
    for (const float value : *values) EXPECT_TRUE(std::isfinite(value));
  }
}

/// An L in the plane, with uneven triangles.
std::shared_ptr<const Mesh> flatL() {
  return test::surfaceOver(12, 12, false, [](double u, double v) {
    return glm::dvec3(u + 0.3 * u * v, v * v + v - 0.8 * u * (1 - v), 0);
  });
}

TEST(Unwrap, PlaneChartsStayAsTheyAre) {
  const auto mesh = flatL();
  const CutChart chart = test::wholeChart(*mesh);
  const ChartShape shape(chart.surface);
  EXPECT_NEAR(l2Of(chart.surface, conformalMap(shape)), 1, 1e-6);
  const UnwrapResult result = test::unwrapWhole(*mesh, kFree);
  expectSound(result);
  EXPECT_NEAR(only(result).distortion.l2, 1, 1e-6);
  EXPECT_NEAR(only(result).distortion.angle, 1, 1e-4);
  EXPECT_NEAR(test::planeArea(surfaceOf(result), only(result).uv),
              test::surfaceArea(surfaceOf(result)), 1e-9);
}

TEST(Unwrap, AnOpenedTubeUnrolls) {
  const auto mesh = test::surfaceOver(40, 10, true, [](double u, double v) {
    return glm::dvec3(std::cos(2 * kPi * u), std::sin(2 * kPi * u), 3 * v);
  });
  std::vector<std::pair<Index, Index>> cut;
  for (Index r = 0; r < 10; ++r) cut.emplace_back(40 * r, 40 * (r + 1));
  const UnwrapResult result = test::unwrapWhole(*mesh, kFree, cut);
  expectSound(result);
  EXPECT_NEAR(only(result).distortion.l2, 1, 1e-5);
}

TEST(Unwrap, AConeNeedsASlitToUnroll) {
  const auto cone = [](double u, double v) {
    const double r = 0.02 + v;
    return glm::dvec3(r * std::cos(2 * kPi * u), r * std::sin(2 * kPi * u), 2 * r);
  };
  const auto mesh = test::surfaceOver(60, 15, true, cone);
  std::vector<std::pair<Index, Index>> cut;
  for (Index r = 0; r < 15; ++r) cut.emplace_back(60 * r, 60 * (r + 1));
  const UnwrapResult result = test::unwrapWhole(*mesh, kFree, cut);
  expectSound(result);
  EXPECT_NEAR(only(result).distortion.l2, 1, 1e-4);
  EXPECT_GT(only(test::unwrapWhole(*test::sampleMesh("cone", 2000), kFree)).distortion.l2, 1.05);
}

TEST(Unwrap, TheCircleHoldsTheBoundaryByArcLength) {
  const auto mesh = test::sampleMesh("bumps", 2000);
  const UnwrapResult result = test::unwrapWhole(*mesh, kCircle);
  expectSound(result);
  const ChartSurface& s = surfaceOf(result);
  const auto& uv = only(result).uv;
  const auto loops = boundaryLoops(s);
  // The circle's centre and radius from three far places.
  const std::size_t n = loops.front().size();
  const auto at = [&](std::size_t i) { return uv[s.sideStart(loops.front()[i % n])]; };
  const glm::dvec2 a = at(0), b = at(n / 3) - a, c = at(2 * n / 3) - a;
  const double d = 2 * (b.x * c.y - b.y * c.x);
  const glm::dvec2 center = a + glm::dvec2(c.y * glm::dot(b, b) - b.y * glm::dot(c, c),
                                           b.x * glm::dot(c, c) - c.x * glm::dot(b, b)) /
                                    d;
  const double radius = glm::distance(a, center);
  double perimeter = 0;
  for (const Index side : loops.front()) perimeter += sideLength(s, side);
  for (std::size_t i = 0; i < n; ++i) {
    EXPECT_NEAR(glm::distance(at(i), center), radius, 1e-9 * radius);
    const glm::dvec2 from = at(i) - center, to = at(i + 1) - center;
    const double angle = std::atan2(from.x * to.y - from.y * to.x, glm::dot(from, to));
    EXPECT_NEAR(angle, 2 * kPi * sideLength(s, loops.front()[i]) / perimeter, 1e-9);
  }
}

TEST(Unwrap, AHalfSphereOnACircleIsItsStereographicMap) {
  const auto mesh = test::surfaceOver(120, 40, true, [](double u, double v) {
    const double theta = kPi / 2 * std::max(v, 1e-3);
    return glm::dvec3(std::sin(theta) * std::cos(2 * kPi * u),
                      std::sin(theta) * std::sin(2 * kPi * u), std::cos(theta));
  });
  // Close the tiny hole at the pole.
  InputMesh input = test::copyInput(*mesh);
  for (Index c = 1; c + 1 < 120; ++c) {
    input.corners.insert(input.corners.end(), {c + 1, c, 0});
    input.faceStart.push_back(input.corners.size());
  }
  const auto closed = test::rebuild(std::move(input));
  const UnwrapResult result = test::unwrapWhole(*closed, kCircle);
  expectSound(result);
  // Scale 1 / cos^2(theta / 2): the mean of its inverse square over the area is 7 / 12, and the
  // disk has twice the area.
  EXPECT_NEAR(only(result).distortion.l2, std::sqrt(7.0 / 6), 2e-3);
  EXPECT_NEAR(only(result).distortion.angle, 1, 5e-2);
}

/// A flat strip wound up around an axis by `turns`: laid flat it lies on itself.
std::shared_ptr<const Mesh> wound(double turns) {
  return test::surfaceOver(160, 4, false, [=](double u, double v) {
    const double angle = 2 * kPi * turns * u, r = 2 - v;
    return glm::dvec3(r * std::cos(angle), r * std::sin(angle), 0.05 * angle);
  });
}

TEST(Unwrap, AWoundStripDoesNotCoverItself) {
  const auto mesh = wound(1.4);
  const CutChart chart = test::wholeChart(*mesh);
  const ChartShape shape(chart.surface);
  Progress progress;
  std::vector<glm::dvec2> free = conformalMap(shape);
  ASSERT_TRUE(localGlobalSteps(shape, 12, progress, free));
  ASSERT_TRUE(allPositive(shape.rest, free));
  // The map without a guard does cover itself: its winding is more than a full turn.
  double turned = 0;
  for (Index c = 0; c < 160; ++c) {
    const glm::dvec2 before = free[shape.boundary[c]], at = free[shape.boundary[c + 1]];
    const glm::dvec2 after = free[shape.boundary[c + 2]];
    const glm::dvec2 e = at - before, f = after - at;
    turned += std::atan2(e.x * f.y - e.y * f.x, glm::dot(e, f));
  }
  EXPECT_GT(std::abs(turned), 2.2 * kPi);
  const UnwrapResult result = test::unwrapWhole(*mesh, kFree);
  expectSound(result);
  EXPECT_LT(only(result).distortion.l2, 1.2);
}

TEST(Unwrap, TheSidesOfASlitInAFlatRingArePartedInThePlane) {
  const auto mesh = test::surfaceOver(48, 6, true, [](double u, double v) {
    const double r = 2 - v;
    return glm::dvec3(r * std::cos(2 * kPi * u), r * std::sin(2 * kPi * u), 0);
  });
  std::vector<std::pair<Index, Index>> cut;
  for (Index r = 0; r < 6; ++r) cut.emplace_back(48 * r, 48 * (r + 1));
  const UnwrapResult result = test::unwrapWhole(*mesh, kFree, cut);
  expectSound(result);
  EXPECT_NEAR(only(result).distortion.l2, 1, 1e-3);
  const ChartSurface& s = surfaceOf(result);
  double edge = 0;
  for (Index side = 0; side < s.opposite.size(); ++side) edge += sideLength(s, side);
  edge /= static_cast<double>(s.opposite.size());
  int copies = 0;
  for (Index a = 0; a < s.vertexCount(); ++a) {
    for (Index b = a + 1; b < s.vertexCount(); ++b) {
      if (s.meshVertex[a] != s.meshVertex[b]) continue;
      ++copies;
      EXPECT_GT(glm::distance(only(result).uv[a], only(result).uv[b]), 2e-3 * edge);
    }
  }
  EXPECT_EQ(copies, 7);
}

/// A tube with a round end, open at the bottom.
std::shared_ptr<const Mesh> finger(double length) {
  const auto tube = [=](double u, double v) {
    const double walked = v * (length + kPi / 2);
    const double theta = walked < length ? kPi / 2 : kPi / 2 - (walked - length) * 0.98;
    const double z = walked < length ? walked : length + std::cos(theta);
    return glm::dvec3(std::sin(theta) * std::cos(2 * kPi * u),
                      std::sin(theta) * std::sin(2 * kPi * u), z);
  };
  InputMesh input = test::copyInput(*test::surfaceOver(24, 60, true, tube));
  for (Index c = 1; c + 1 < 24; ++c) {
    input.corners.insert(input.corners.end(), {60 * 24, 60 * 24 + c, 60 * 24 + c + 1});
    input.faceStart.push_back(input.corners.size());
  }
  return test::rebuild(std::move(input));
}

TEST(Unwrap, LongFingersAreSlit) {
  const auto mesh = finger(12);
  for (const auto boundary : {UnwrapOptions::Boundary::Free, UnwrapOptions::Boundary::Circle}) {
    const UnwrapResult plain = test::unwrapWhole(*mesh, {boundary, 0});
    expectSound(plain);
    EXPECT_TRUE(plain.charts->charts[0].cuts.empty());
    const UnwrapResult slit = test::unwrapWhole(*mesh, {boundary, 1.5});
    expectSound(slit);
    const CutChart& chart = slit.charts->charts[0];
    ASSERT_FALSE(chart.cuts.empty());
    EXPECT_LE(chart.cuts.size(), 8u);
    for (const Cut& cut : chart.cuts) EXPECT_EQ(cut.reason, CutReason::Relief);
    EXPECT_TRUE(chart.disk());
    EXPECT_LT(only(slit).distortion.l2, 0.7 * only(plain).distortion.l2);
    if (boundary == UnwrapOptions::Boundary::Free) {
      EXPECT_LT(only(slit).distortion.l2, 1.5);
    }
  }
}

TEST(Unwrap, ChartsWithoutStretchAreNotSlit) {
  const UnwrapResult result =
      test::unwrapWhole(*test::sampleMesh("bumps", 2000), {UnwrapOptions::Boundary::Free, 1.5});
  expectSound(result);
  EXPECT_TRUE(result.charts->charts[0].cuts.empty());
}

TEST(Unwrap, APocketBetweenTwoEdgesOfTheSameVerticesIsSlit) {
  // Two triangles on the same three vertices, glued along two edges, inside a square: without a
  // slit the two edges between vertices 4 and 5 lie on each other.
  const auto mesh = test::meshOf(
      {{-2, -2, 0}, {2, -2, 0}, {2, 2, 0}, {-2, 2, 0}, {-1, 0, 0}, {1, 0, 0}, {0, 0, 1}},
      {{0, 1, 4}, {1, 5, 4}, {1, 2, 5}, {2, 3, 5}, {3, 4, 5}, {3, 0, 4}});
  ChartSurface s = test::wholeChart(*mesh).surface;
  // Glue the pocket in between by hand; a mesh would call edge 4-5 non-manifold.
  const auto sideOf = [&](Index a, Index b) {
    for (Index side = 0; side < s.opposite.size(); ++side) {
      if (s.sideStart(side) == a && s.sideEnd(side) == b) return side;
    }
    return kNone;
  };
  std::vector<Index> local(7, kNone);
  for (Index v = 0; v < s.vertexCount(); ++v) local[s.meshVertex[v]] = v;
  const Index below = sideOf(local[5], local[4]), above = sideOf(local[4], local[5]);
  ASSERT_NE(below, kNone);
  ASSERT_NE(above, kNone);
  const Index tip = static_cast<Index>(s.vertexCount());
  s.positions.push_back({0, 0, 0.2});
  s.meshVertex.push_back(6);
  const Index first = static_cast<Index>(3 * s.triangleCount());
  s.triangles.push_back({local[4], local[5], tip});
  s.triangles.push_back({local[5], local[4], tip});
  s.meshTriangle.insert(s.meshTriangle.end(), {4, 5});
  s.opposite.insert(s.opposite.end(), {below, first + 5, first + 4, above, first + 2, first + 1});
  s.opposite[below] = first;
  s.opposite[above] = first + 3;
  CutChart chart;
  chart.surface = s;
  chart.topology = topologyOf(s);
  ASSERT_TRUE(chart.disk());
  for (const auto boundary : {UnwrapOptions::Boundary::Free, UnwrapOptions::Boundary::Circle}) {
    Progress progress;
    const UnwrapResult result =
        unwrapCharts(*mesh, test::setOf({chart}), {boundary, 1.5}, progress);
    ASSERT_EQ(result.charts->charts[0].cuts.size(), 1u);
    test::expectOneToOne(surfaceOf(result), only(result).uv);
  }
}

TEST(Unwrap, SmallestChartsAreLaidFlat) {
  const test::Polygons one{{0, 1, 2}};
  for (const double scale : {1.0, 1e-30, 1e30}) {
    const auto triangle =
        test::meshOf({{0, 0, 0}, {3 * scale, 0, 0}, {scale, scale, 2 * scale}}, one);
    const auto pair = test::meshOf({{0, 0, 0}, {scale, 0, 0}, {scale, scale, 0}, {0, scale, scale}},
                                   {{0, 1, 2}, {0, 2, 3}});
    const auto polygon = test::meshOf(
        {{0, 0, 0}, {scale, 0, 0}, {2 * scale, scale, 0}, {scale, 2 * scale, 0}, {0, scale, 0}},
        {{0, 1, 2, 3, 4}});
    const auto strip = test::surfaceOver(30, 1, false, [=](double u, double v) {
      return scale * glm::dvec3(10 * u, v, std::sin(5 * u));
    });
    for (const auto& mesh : {triangle, pair, polygon, strip}) {
      const UnwrapResult free = test::unwrapWhole(*mesh, {UnwrapOptions::Boundary::Free, 1.5});
      expectSound(free);
      EXPECT_NEAR(only(free).distortion.l2, 1, 1e-5);
      expectSound(test::unwrapWhole(*mesh, {UnwrapOptions::Boundary::Circle, 1.5}));
    }
  }
}

TEST(Unwrap, DegenerateChartsStayFiniteAndUnflipped) {
  // Collinear, doubled and coinciding points in a grid; then nothing but such triangles.
  const auto bad = [](int kind) {
    return test::surfaceOver(8, 8, false, [=](double u, double v) {
      const double x = kind == 0 && u > 0.3 && u < 0.6 ? 0.45 : u;
      if (kind == 2) return glm::dvec3(u + v, 0, 0);
      if (kind == 3) return glm::dvec3(u < 0.5 ? 0 : 1, v < 0.5 ? 0 : 1e-9, 0);
      return glm::dvec3(x, kind == 1 && v > 0.5 ? 0.5 + 1e-12 * v : v, 0);
    });
  };
  for (int kind = 0; kind < 4; ++kind) {
    SCOPED_TRACE(kind);
    expectSound(test::unwrapWhole(*bad(kind), {UnwrapOptions::Boundary::Free, 1.5}));
    expectSound(test::unwrapWhole(*bad(kind), {UnwrapOptions::Boundary::Circle, 1.5}));
  }
}

TEST(Unwrap, ChartsThatAreNoDisksSayWhy) {
  const auto mesh = test::sampleMesh("sphere", 500);
  const UnwrapResult result = test::unwrapWhole(*mesh, {});
  EXPECT_EQ(only(result).problem, "It is no disk.");
  EXPECT_TRUE(only(result).uv.empty());
  ASSERT_EQ(result.unwrap->stretch.size(), mesh->triangleCount());
  for (const float value : result.unwrap->stretch) EXPECT_TRUE(std::isnan(value));
}

/// Every 16th of a mesh of bands as a chart.
std::shared_ptr<const ChartSet> bands(const Mesh& mesh) {
  std::vector<Index> label(mesh.faceCount());
  for (Index f = 0; f < label.size(); ++f) {
    label[f] = static_cast<Index>(16 * f / mesh.faceCount());
  }
  std::vector<CutChart> charts;
  for (ChartSurface& surface : extractCharts(mesh, label, 16)) {
    CutChart& chart = charts.emplace_back();
    chart.topology = topologyOf(surface);
    chart.problem = chart.disk() ? "" : "It is no disk.";
    chart.surface = std::move(surface);
  }
  return test::setOf(std::move(charts));
}

TEST(Unwrap, DoesNotDependOnTheNumberOfThreads) {
  const auto mesh = wound(1.4);
  const auto hills = test::surfaceOver(96, 96, false, [](double u, double v) {
    return glm::dvec3(u, v, 0.2 * std::sin(9 * u) * std::sin(7 * v));
  });
  for (const auto& [shape, set] :
       {std::pair(mesh, test::setOf({test::wholeChart(*mesh)})), std::pair(hills, bands(*hills))}) {
    for (const auto boundary : {UnwrapOptions::Boundary::Free, UnwrapOptions::Boundary::Circle}) {
      std::vector<UnwrapResult> results;
      for (const unsigned threads : {1u, 2u}) {
        setThreadCount(threads);
        Progress progress;
        results.push_back(unwrapCharts(*shape, set, {boundary, 1.5}, progress));
        EXPECT_EQ(progress.fraction(), 1.0f);
      }
      setThreadCount(0);
      ASSERT_EQ(results[0].unwrap->charts.size(), results[1].unwrap->charts.size());
      for (std::size_t c = 0; c < results[0].unwrap->charts.size(); ++c) {
        EXPECT_TRUE(results[0].unwrap->charts[c].uv == results[1].unwrap->charts[c].uv);
      }
      EXPECT_EQ(results[0].unwrap->stretch, results[1].unwrap->stretch);
    }
  }
}

TEST(Unwrap, CancellingGivesNothing) {
  const auto mesh = test::sampleMesh("bumps", 2000);
  Progress progress;
  progress.cancel();
  const UnwrapResult result =
      unwrapCharts(*mesh, test::setOf({test::wholeChart(*mesh)}), {}, progress);
  EXPECT_EQ(result.charts, nullptr);
  EXPECT_EQ(result.unwrap, nullptr);
}

}  // namespace
}  // namespace chartflood
