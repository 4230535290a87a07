// Areas on the unit sphere: core/gauss/spherical_polygon.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "core/gauss/spherical_polygon.h"
#include "core/gauss/winding_area.h"

namespace chartflood {
namespace {

const glm::dvec3 kX(1, 0, 0), kY(0, 1, 0), kZ(0, 0, 1);

glm::dvec3 polar(double latitude, double longitude) {
  return {std::cos(latitude) * std::cos(longitude), std::cos(latitude) * std::sin(longitude),
          std::sin(latitude)};
}

double absoluteArea(const std::vector<glm::dvec3>& corners) {
  return polygonArea(corners).absolute;
}

double signedArea(const std::vector<glm::dvec3>& corners) {
  return polygonArea(corners).signedArea;
}

/// The same from every corner.
void expectNoBeginning(std::vector<glm::dvec3> corners) {
  const PolygonArea area = polygonArea(corners);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    std::rotate(corners.begin(), corners.begin() + 1, corners.end());
    EXPECT_NEAR(polygonArea(corners).absolute, area.absolute, 1e-12);
    EXPECT_NEAR(polygonArea(corners).signedArea, area.signedArea, 1e-12);
  }
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
  EXPECT_NEAR(signedArea(cap), exact, 1e-5);
  EXPECT_NEAR(absoluteArea(cap), exact, 1e-5);
  std::vector<glm::dvec3> reversed(cap.rbegin(), cap.rend());
  EXPECT_NEAR(absoluteArea(reversed), exact, 1e-5);
}

TEST(SphericalPolygon, BowTieCountsBothWings) {
  // Four corners of a small square, joined crosswise: two triangles of opposite sign.
  const glm::dvec3 a = polar(-0.1, -0.1), b = polar(-0.1, 0.1), c = polar(0.1, 0.1),
                   d = polar(0.1, -0.1);
  const std::vector<glm::dvec3> tie = {a, b, d, c};
  EXPECT_NEAR(signedArea(tie), 0, 1e-12);
  const std::vector<glm::dvec3> square = {a, b, c, d};
  const double whole = absoluteArea(square);
  EXPECT_NEAR(absoluteArea(tie), whole / 2, whole * 1e-2);
  EXPECT_GT(whole, 0.039);
}

TEST(SphericalPolygon, ComplementIsNeverTaken) {
  // Nearly the whole sphere, left out a small triangle: its area is the triangle's.
  const std::vector<glm::dvec3> triangle = {polar(0, 0), polar(0, 0.1), polar(0.1, 0)};
  const std::vector<glm::dvec3> around(triangle.rbegin(), triangle.rend());
  EXPECT_NEAR(absoluteArea(around), absoluteArea(triangle), 1e-15);
}

TEST(SphericalPolygon, LoopsThatRunTwiceCountTwice) {
  // Around the pole twice, at two heights.
  std::vector<glm::dvec3> twice;
  for (int i = 0; i < 40; ++i) {
    twice.push_back(polar(i < 20 ? 1.0 : 1.2, 2 * std::numbers::pi * i / 20));
  }
  std::vector<glm::dvec3> wide(twice.begin(), twice.begin() + 20),
      narrow(twice.begin() + 20, twice.end());
  const double both = absoluteArea(wide) + absoluteArea(narrow);
  EXPECT_NEAR(absoluteArea(twice), both, 0.05);
  EXPECT_NEAR(signedArea(twice), absoluteArea(twice), 1e-12);
  expectNoBeginning(twice);
}

TEST(SphericalPolygon, LoopsAgainstEachOtherCancel) {
  // A large loop, a bridge, a small loop inside the other way round: a ring.
  std::vector<glm::dvec3> ring;
  for (int i = 0; i <= 12; ++i) ring.push_back(polar(0.5, 2 * std::numbers::pi * i / 12));
  for (int i = 12; i >= 0; --i) ring.push_back(polar(1.0, 2 * std::numbers::pi * i / 12));
  std::vector<glm::dvec3> wide(ring.begin(), ring.begin() + 12),
      narrow(ring.begin() + 14, ring.end());
  EXPECT_NEAR(absoluteArea(ring), absoluteArea(wide) - absoluteArea(narrow), 1e-12);
  expectNoBeginning(ring);
}

TEST(SphericalPolygon, WingsThatOnlyTouchCountBoth) {
  const glm::dvec3 a = polar(0, 0);
  const std::vector<glm::dvec3> wings = {a, polar(-0.2, 0.3),  polar(0.2, 0.3),
                                         a, polar(-0.2, -0.3), polar(0.2, -0.3)};
  const double wing = absoluteArea({wings[0], wings[1], wings[2]});
  EXPECT_NEAR(absoluteArea(wings), 2 * wing, 1e-12);
  EXPECT_NEAR(signedArea(wings), 0, 1e-12);
  expectNoBeginning(wings);
  // Moved apart by less than anything that is seen, to either side.
  for (const double off : {1e-14, -1e-14}) {
    std::vector<glm::dvec3> near = wings;
    near[3] = polar(0, off);
    EXPECT_NEAR(absoluteArea(near), 2 * wing, 1e-10);
    near[3] = polar(off, 0);
    EXPECT_NEAR(absoluteArea(near), 2 * wing, 1e-10);
  }
}

TEST(SphericalPolygon, RandomOnesHaveNoBeginning) {
  std::mt19937 random(9);
  const auto unit = [&] { return static_cast<double>(random() % 2001) / 1000 - 1; };
  for (int round = 0; round < 500; ++round) {
    std::vector<glm::dvec3> corners;
    for (std::size_t i = 0; i < 4 + random() % 7; ++i) {
      glm::dvec3 p(unit(), unit(), unit());
      // Many of them along the axes, as in machine parts.
      if (round % 2 == 0) p = glm::round(p);
      if (glm::length(p) > 0.1) corners.push_back(glm::normalize(p));
    }
    expectNoBeginning(corners);
    const PolygonArea area = polygonArea(corners);
    EXPECT_GE(area.absolute, std::min(std::abs(area.signedArea), 4 * std::numbers::pi) - 1e-12);
  }
}

TEST(SphericalPolygon, SlicesAgreeWithFansWhereNothingCrosses) {
  std::mt19937 random(4);
  for (int round = 0; round < 200; ++round) {
    std::vector<glm::dvec3> star;
    const int corners = 5 + static_cast<int>(random() % 9);
    const glm::dvec3 tilt = glm::normalize(glm::dvec3(random() % 7, random() % 7, 1));
    for (int i = 0; i < corners; ++i) {
      const glm::dvec3 p = polar(0.2 + 0.001 * static_cast<double>(random() % 1000),
                                 2 * std::numbers::pi * i / corners);
      star.push_back(2 * glm::dot(p, tilt) * tilt - p);
    }
    EXPECT_NEAR(windingArea(star).absolute, absoluteArea(star), 1e-12);
    EXPECT_NEAR(windingArea(star).signedArea, signedArea(star), 1e-12);
  }
}

TEST(SphericalPolygon, ManyCrossingsEnd) {
  std::vector<glm::dvec3> star;
  for (int i = 0; i < 201; ++i) star.push_back(polar(0.5, 2 * std::numbers::pi * i * 100 / 201));
  const double area = absoluteArea(star);
  EXPECT_GT(area, 0);
  EXPECT_LE(area, 4 * std::numbers::pi);
}

}  // namespace
}  // namespace chartflood
