// Triangles of polygons: core/model/triangulate_polygon.

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <set>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "core/model/triangulate_polygon.h"
#include "tests/support/test_meshes.h"

namespace chartflood {
namespace {

/// A polygon by places; equal places are one vertex.
struct Outline {
  std::vector<Index> polygon;
  std::vector<glm::dvec3> positions;

  void add(const glm::dvec3& p) {
    const auto at = std::find(positions.begin(), positions.end(), p);
    polygon.push_back(static_cast<Index>(at - positions.begin()));
    if (at == positions.end()) positions.push_back(p);
  }
  glm::dvec3 at(std::size_t corner) const { return positions[polygon[corner]]; }
  /// Twice the area, as a vector.
  glm::dvec3 normal() const {
    glm::dvec3 sum(0);
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
      sum += glm::cross(at(i) - at(0), at(i + 1) - at(0));
    }
    return sum;
  }
};

Outline outlineOf(const std::vector<glm::dvec2>& points) {
  Outline outline;
  for (const auto& p : points) outline.add({p.x, p.y, 0});
  return outline;
}

/// n - 2 triangles that are one disk bounded by the polygon.
void expectDisk(const Outline& o, const PolygonTriangulator& t) {
  const std::size_t n = o.polygon.size();
  ASSERT_EQ(t.triangles().size(), n - 2);
  ASSERT_EQ(t.diagonals().size(), n - 3);
  std::set<Index> inner;
  for (const auto& [a, b] : t.diagonals()) {
    EXPECT_TRUE(inner.insert(a).second && inner.insert(b).second);
    const auto &x = t.triangles()[a / 3], &y = t.triangles()[b / 3];
    EXPECT_EQ(x[a % 3], y[(b + 1) % 3]);
    EXPECT_EQ(x[(a + 1) % 3], y[b % 3]);
  }
  std::set<Index> outer;
  for (Index s = 0; s < 3 * t.triangles().size(); ++s) {
    if (inner.contains(s)) continue;
    const auto& x = t.triangles()[s / 3];
    EXPECT_EQ((x[s % 3] + 1) % n, x[(s + 1) % 3]) << "an edge of the outline";
    EXPECT_TRUE(outer.insert(x[s % 3]).second);
  }
  EXPECT_EQ(outer.size(), n);
}

/// All triangles face the polygon's side: with a disk of them, they cover it once.
void expectCovered(const Outline& o, const PolygonTriangulator& t) {
  const glm::dvec3 normal = o.normal();
  const double whole = glm::dot(normal, normal);
  double sum = 0;
  for (const auto& [a, b, c] : t.triangles()) {
    const double part = glm::dot(glm::cross(o.at(b) - o.at(a), o.at(c) - o.at(a)), normal);
    EXPECT_GE(part, -1e-9 * whole);
    sum += std::abs(part);
  }
  EXPECT_NEAR(sum, whole, 1e-9 * whole);
}

void expectRight(const Outline& outline) {
  PolygonTriangulator t;
  t.run(outline.polygon, outline.positions);
  expectDisk(outline, t);
  expectCovered(outline, t);
  // From any corner.
  Outline turned = outline;
  std::rotate(turned.polygon.begin(), turned.polygon.begin() + 1, turned.polygon.end());
  t.run(turned.polygon, turned.positions);
  expectDisk(turned, t);
  expectCovered(turned, t);
}

/// Radii at random around the origin.
std::vector<glm::dvec2> star(Index corners, std::mt19937& random) {
  std::vector<glm::dvec2> points;
  for (Index i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners;
    const double radius = 1 + 3 * static_cast<double>(random() % 1000) / 1000;
    points.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return points;
}

TEST(TriangulatePolygon, FansWhatAFanCovers) {
  const Outline hexagon = outlineOf({{2, 0}, {1, 2}, {-1, 2}, {-2, 0}, {-1, -2}, {1, -2}});
  PolygonTriangulator t;
  t.run(hexagon.polygon, hexagon.positions);
  for (Index i = 0; i < 4; ++i) {
    EXPECT_EQ(t.triangles()[i], (PolygonTriangulator::Triangle{0, i + 1, i + 2}));
  }
  expectRight(hexagon);
}

TEST(TriangulatePolygon, CoversConcaveOutlines) {
  expectRight(outlineOf({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}));
  expectRight(outlineOf({{0, 0}, {4, 0}, {4, 4}, {3, 4}, {3, 1}, {1, 1}, {1, 4}, {0, 4}}));
  expectRight(outlineOf({{0, 0}, {1, 1}, {2, 0}, {1, 3}}));
  std::mt19937 random(11);
  for (int round = 0; round < 200; ++round)
    expectRight(outlineOf(star(static_cast<Index>(5 + random() % 60), random)));
}

TEST(TriangulatePolygon, CoversHolesBehindSlits) {
  // A square with a square hole, reached by a slit from its first corner.
  const Outline ring =
      outlineOf({{0, 0}, {3, 0}, {3, 3}, {0, 3}, {0, 0}, {1, 1}, {1, 2}, {2, 2}, {2, 1}, {1, 1}});
  expectRight(ring);
  // Two holes, one behind the other.
  expectRight(outlineOf({{0, 0},
                         {6, 0},
                         {6, 3},
                         {0, 3},
                         {0, 0},
                         {1, 1},
                         {1, 2},
                         {2, 2},
                         {4, 2},
                         {5, 2},
                         {5, 1},
                         {4, 1},
                         {4, 2},
                         {2, 2},
                         {2, 1},
                         {1, 1}}));
}

TEST(TriangulatePolygon, CoversRandomOutlinesWithSlits) {
  std::mt19937 random(23);
  for (int round = 0; round < 200; ++round) {
    std::vector<glm::dvec2> points = star(static_cast<Index>(6 + random() % 40), random);
    // A small hole around the centre, run through clockwise, from any corner of the outline.
    const std::size_t from = random() % points.size();
    std::vector<glm::dvec2> hole;
    const Index sides = static_cast<Index>(3 + random() % 9);
    const double start = std::atan2(points[from].y, points[from].x);
    for (Index i = 0; i < sides; ++i) {
      const double angle = start - 2 * std::numbers::pi * i / sides;
      hole.emplace_back(0.4 * std::cos(angle), 0.4 * std::sin(angle));
    }
    hole.push_back(hole.front());
    hole.push_back(points[from]);
    points.insert(points.begin() + static_cast<std::ptrdiff_t>(from) + 1, hole.begin(), hole.end());
    expectRight(outlineOf(points));
  }
}

TEST(TriangulatePolygon, CoversOutlinesThatTouchThemselves) {
  // A square with a hole that reaches its corner.
  expectRight(outlineOf({{0, 0}, {2, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {1, 2}, {2, 3}, {3, 2}}));
}

TEST(TriangulatePolygon, StaysADiskWhereItHangsByACorner) {
  // Two squares that meet in a corner: no triangle may have that corner twice, so one is turned.
  const Outline squares =
      outlineOf({{0, 0}, {1, 0}, {1, 1}, {2, 1}, {2, 2}, {1, 2}, {1, 1}, {0, 1}});
  PolygonTriangulator t;
  t.run(squares.polygon, squares.positions);
  expectDisk(squares, t);
}

TEST(TriangulatePolygon, StaysADiskWhereItCrossesItself) {
  PolygonTriangulator t;
  std::mt19937 random(5);
  for (int round = 0; round < 100; ++round) {
    Outline outline;
    for (Index i = 0; i < 4 + random() % 20; ++i) {
      outline.add({random() % 1000, random() % 1000, random() % 100});
    }
    if (std::set<Index>(outline.polygon.begin(), outline.polygon.end()).size() <
        outline.polygon.size()) {
      continue;
    }
    t.run(outline.polygon, outline.positions);
    expectDisk(outline, t);
  }
}

TEST(TriangulatePolygon, LeavesOutWhatBoundsNothing) {
  const Outline spike = outlineOf({{0, 0}, {1, 0}, {1, 1}, {2, 2}, {1, 1}, {1, 1}, {0, 1}});
  PolygonTriangulator t;
  t.run(spike.polygon, spike.positions);
  EXPECT_EQ(t.triangles().size(), 2u);
  const Outline twoCorners = outlineOf({{0, 0}, {1, 0}, {1, 0}, {0, 0}});
  t.run(twoCorners.polygon, twoCorners.positions);
  EXPECT_TRUE(t.triangles().empty());
}

TEST(TriangulatePolygon, KeepsFacesThatAreNothingButSpikes) {
  PolygonTriangulator t;
  for (const auto& points : {std::vector<glm::dvec2>{{0, 0}, {1, 0}, {2, 0}, {1, 0}},
                             {{1, 0}, {0, 0}, {1, 0}, {2, 0}}}) {
    const Outline line = outlineOf(points);
    t.run(line.polygon, line.positions);
    EXPECT_EQ(t.triangles().size(), 2u);
  }
}

TEST(TriangulatePolygon, SeesSpacePolygonsAlongTheirNormal) {
  // An L on a slope, slightly bent.
  Outline slope;
  for (const auto& [x, y] : {std::pair(0, 0), {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}) {
    slope.add({x, y, 3.0 * x - 2.0 * y + 0.01 * x * y});
  }
  PolygonTriangulator t;
  t.run(slope.polygon, slope.positions);
  expectDisk(slope, t);
  const glm::dvec3 normal = slope.normal();
  for (const auto& [a, b, c] : t.triangles()) {
    EXPECT_GT(glm::dot(glm::cross(slope.at(b) - slope.at(a), slope.at(c) - slope.at(a)), normal),
              0);
  }
}

TEST(TriangulatePolygon, TakesManyCorners) {
  std::mt19937 random(3);
  expectRight(outlineOf(star(5000, random)));
  std::vector<glm::dvec2> comb;  // teeth as long as the comb is wide
  for (int i = 0; i < 1000; ++i) {
    comb.emplace_back(i, 0);
    comb.emplace_back(i + 0.5, 1000);
  }
  comb.emplace_back(1000, -1);
  comb.emplace_back(0, -1);
  std::reverse(comb.begin(), comb.end());
  expectRight(outlineOf(comb));
}

TEST(TriangulatePolygon, AKeyholeIsOneFaceThatCanBeCutAlongItsSlit) {
  const Outline ring =
      outlineOf({{0, 0}, {3, 0}, {3, 3}, {0, 3}, {0, 0}, {1, 1}, {1, 2}, {2, 2}, {2, 1}, {1, 1}});
  const auto mesh = test::meshOf(ring.positions, {ring.polygon, {4, 7, 6, 5}});
  EXPECT_EQ(mesh->faceCount(), 2u);
  EXPECT_EQ(mesh->boundaryLoopCount(), 1u);
  EXPECT_TRUE(mesh->repairs().empty());
  std::size_t slits = 0;
  for (Index s = 0; s < 3 * mesh->triangleCount(); ++s) {
    const Index other = mesh->opposite()[s];
    if (other == kNone || mesh->faceOf(s / 3) != mesh->faceOf(other / 3)) continue;
    slits += mesh->isDiagonal(s) ? 0 : 1;
  }
  EXPECT_EQ(slits, 2u);
}

}  // namespace
}  // namespace chartflood
