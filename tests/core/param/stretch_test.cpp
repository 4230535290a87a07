// Distortion of flat triangles against sampled directions.

#include "core/param/stretch.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include <glm/geometric.hpp>

#include "tests/core/param/param_support.h"

namespace chartflood {
namespace {

ChartSurface oneTriangle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  ChartSurface s;
  s.meshTriangle = {0};
  s.triangles = {{0, 1, 2}};
  s.opposite = {kNone, kNone, kNone};
  s.meshVertex = {0, 1, 2};
  s.positions = {a, b, c};
  return s;
}

/// Length in space of a unit step in the plane, over all directions.
struct Sampled {
  double rms = 0, largest = 0, smallest = 1e300;
  Sampled(const ChartSurface& s, const std::vector<glm::dvec2>& uv) {
    const glm::dvec2 e1 = uv[1] - uv[0], e2 = uv[2] - uv[0];
    const double det = e1.x * e2.y - e1.y * e2.x;
    constexpr int kSamples = 20000;
    for (int i = 0; i < kSamples; ++i) {
      const double angle = 2 * std::numbers::pi * i / kSamples;
      const glm::dvec2 d(std::cos(angle), std::sin(angle));
      // Cramer: d = a e1 + b e2.
      const double a = (d.x * e2.y - d.y * e2.x) / det, b = (e1.x * d.y - e1.y * d.x) / det;
      const double length = glm::length(a * (s.positions[1] - s.positions[0]) +
                                        b * (s.positions[2] - s.positions[0]));
      rms += length * length / kSamples;
      largest = std::max(largest, length);
      smallest = std::min(smallest, length);
    }
    rms = std::sqrt(rms);
  }
};

TEST(Stretch, OfRandomTrianglesEqualsThatOfSampledDirections) {
  std::mt19937 random(7);
  const auto number = [&] { return static_cast<double>(random()) / 4294967296.0 * 2 - 1; };
  for (int trial = 0; trial < 50; ++trial) {
    const ChartSurface s =
        oneTriangle({number(), number(), number()}, {number(), number(), number()},
                    {number(), number(), number()});
    const std::vector<glm::dvec2> uv{
        {number(), number()}, {number(), number()}, {number(), number()}};
    const double plane = std::abs(test::planeArea(s, uv));
    if (plane < 1e-2) continue;
    const double factor = std::sqrt(plane / test::surfaceArea(s));
    const Sampled expected(s, uv);
    const auto triangles = triangleDistortion(s, uv);
    EXPECT_NEAR(triangles[0].l2, expected.rms * factor, 1e-6 * triangles[0].l2);
    EXPECT_NEAR(triangles[0].linf, expected.largest * factor, 1e-6 * triangles[0].linf);
    EXPECT_NEAR(triangles[0].angle, expected.largest / expected.smallest,
                1e-4 * triangles[0].angle);
    EXPECT_NEAR(triangles[0].areaRatio, 1, 1e-9) << "a triangle alone is its own chart";
  }
}

TEST(Stretch, OfAChartIsTheWeightedMean) {
  // Two right triangles of area 1/2; the second one is twice as long in the plane.
  const auto mesh =
      test::meshOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}}, {{0, 1, 2}, {0, 2, 3}});
  const CutChart chart = test::wholeChart(*mesh);
  std::vector<glm::dvec2> uv;
  for (const glm::dvec3& p : chart.surface.positions) uv.emplace_back(p.x < 0 ? 2 * p.x : p.x, p.y);
  const auto triangles = triangleDistortion(chart.surface, uv);
  const Distortion d = chartDistortion(chart.surface, triangles);
  // Singular values (1, 1) and (2, 1); areas in the plane 1 and 2 for 1 in space each.
  EXPECT_NEAR(d.l2, std::sqrt((1.0 + 0.625) / 2 * 1.5), 1e-9);
  EXPECT_NEAR(d.linf, std::sqrt(1.5), 1e-9);
  EXPECT_NEAR(d.angle, (1.0 + 2.0) / 2, 1e-9);
  EXPECT_NEAR(d.area, (1.5 + 2 / 1.5) / 2, 1e-9);
  EXPECT_EQ(d.flipped, 0u);
}

TEST(Stretch, CountsFlipsAgainstTheMajorityAndStaysFinite) {
  const auto mesh = test::grid(4, true);
  const CutChart chart = test::wholeChart(*mesh);
  std::vector<glm::dvec2> uv;
  for (const glm::dvec3& p : chart.surface.positions) uv.emplace_back(-p.x, p.y);
  auto triangles = triangleDistortion(chart.surface, uv);
  Distortion d = chartDistortion(chart.surface, triangles);
  EXPECT_EQ(d.flipped, 0u) << "a mirrored chart faces one way";
  EXPECT_NEAR(d.l2, 1, 1e-12);
  // All in one point.
  std::fill(uv.begin(), uv.end(), glm::dvec2(0));
  triangles = triangleDistortion(chart.surface, uv);
  d = chartDistortion(chart.surface, triangles);
  for (const double x : {d.l2, d.linf, d.area, d.angle}) EXPECT_TRUE(std::isfinite(x));
}

}  // namespace
}  // namespace chartflood
