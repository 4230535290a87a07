// Areas on the unit sphere: core/gauss/spherical_polygon.

#include <cmath>
#include <numbers>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "core/gauss/spherical_polygon.h"

namespace chartflood {
namespace {

const glm::dvec3 kX(1, 0, 0), kY(0, 1, 0), kZ(0, 0, 1);

glm::dvec3 polar(double latitude, double longitude) {
  return {std::cos(latitude) * std::cos(longitude), std::cos(latitude) * std::sin(longitude),
          std::sin(latitude)};
}

TEST(SphericalTriangle, OctantIsHalfPi) {
  EXPECT_NEAR(signedTriangleArea(kX, kY, kZ), std::numbers::pi / 2, 1e-15);
  EXPECT_NEAR(signedTriangleArea(kX, kZ, kY), -std::numbers::pi / 2, 1e-15);
}

TEST(SphericalTriangle, DegenerateOnesAreZero) {
  EXPECT_EQ(signedTriangleArea(kX, kX, kY), 0);
  EXPECT_EQ(signedTriangleArea(kX, -kX, kY), 0);
}

TEST(SphericalTriangle, SmallOnesMatchGirard) {
  // Girard's theorem, by the angles at the corners: an independent formula.
  for (const double size : {0.3, 0.05, 0.01}) {
    const glm::dvec3 a = polar(0.2, 0.1), b = polar(0.2, 0.1 + size), c = polar(0.2 + size, 0.1);
    const auto angle = [](const glm::dvec3& at, const glm::dvec3& p, const glm::dvec3& q) {
      const glm::dvec3 u = glm::cross(at, p), v = glm::cross(at, q);
      return std::atan2(glm::length(glm::cross(u, v)), glm::dot(u, v));
    };
    const double girard = angle(a, b, c) + angle(b, c, a) + angle(c, a, b) - std::numbers::pi;
    EXPECT_NEAR(signedTriangleArea(a, b, c), girard, 1e-12);
  }
}

TEST(SphericalPolygon, FansAddUp) {
  // A cap around the pole: 2 pi (1 - cos(radius)), approached by many corners.
  std::vector<glm::dvec3> cap;
  for (int i = 0; i < 4000; ++i) cap.push_back(polar(1.0, 2 * std::numbers::pi * i / 4000));
  const double exact = 2 * std::numbers::pi * (1 - std::sin(1.0));
  EXPECT_NEAR(signedPolygonArea(cap), exact, 1e-5);
  EXPECT_NEAR(absolutePolygonArea(cap), exact, 1e-5);
  std::vector<glm::dvec3> reversed(cap.rbegin(), cap.rend());
  EXPECT_NEAR(absolutePolygonArea(reversed), exact, 1e-5);
}

TEST(SphericalPolygon, BowTieCountsBothWings) {
  // Four corners of a small square, joined crosswise: two triangles of opposite sign.
  const glm::dvec3 a = polar(-0.1, -0.1), b = polar(-0.1, 0.1), c = polar(0.1, 0.1),
                   d = polar(0.1, -0.1);
  const std::vector<glm::dvec3> tie = {a, b, d, c};
  EXPECT_NEAR(signedPolygonArea(tie), 0, 1e-12);
  const std::vector<glm::dvec3> square = {a, b, c, d};
  const double whole = absolutePolygonArea(square);
  EXPECT_NEAR(absolutePolygonArea(tie), whole / 2, whole * 1e-2);
  EXPECT_GT(whole, 0.039);
}

TEST(SphericalPolygon, ComplementIsNeverTaken) {
  // Nearly the whole sphere, left out a small triangle: its area is the triangle's.
  const std::vector<glm::dvec3> triangle = {polar(0, 0), polar(0, 0.1), polar(0.1, 0)};
  const std::vector<glm::dvec3> around(triangle.rbegin(), triangle.rend());
  EXPECT_NEAR(absolutePolygonArea(around), absolutePolygonArea(triangle), 1e-15);
}

TEST(SphericalPolygon, ManyCrossingsEnd) {
  std::vector<glm::dvec3> star;
  for (int i = 0; i < 201; ++i) star.push_back(polar(0.5, 2 * std::numbers::pi * i * 100 / 201));
  const double area = absolutePolygonArea(star);
  EXPECT_GT(area, 0);
  EXPECT_LE(area, 4 * std::numbers::pi);
}

}  // namespace
}  // namespace chartflood
