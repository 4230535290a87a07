#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "core/base/rng.h"
#include "core/model/triangle_tree.h"
#include "tests/support/test_meshes.h"

namespace chartflood {
namespace {

/// What the tree must find: by looking at every triangle, with another formula (Möller and
/// Trumbore). The share of the way, or 2 when nothing is met.
double nearestByAll(const Mesh& mesh, const glm::dvec3& from, const glm::dvec3& to) {
  const glm::dvec3 way = to - from;
  double nearest = 2;
  for (const auto& [a, b, c] : mesh.triangles()) {
    const auto p = mesh.positions();
    const glm::dvec3 e = p[b] - p[a], f = p[c] - p[a], h = glm::cross(way, f), s = from - p[a];
    const double det = glm::dot(e, h);
    if (det == 0) continue;
    const double u = glm::dot(s, h) / det;
    const glm::dvec3 q = glm::cross(s, e);
    const double v = glm::dot(way, q) / det, t = glm::dot(f, q) / det;
    if (u >= 0 && v >= 0 && u + v <= 1 && t >= 0 && t <= 1) nearest = std::min(nearest, t);
  }
  return nearest;
}

TEST(TriangleTree, FindsWhatLookingAtAllFinds) {
  const auto mesh = test::sampleMesh("bumps", 3000);
  const TriangleTree tree(mesh);
  Rng rng(7);
  const auto number = [&] { return (rng.below(1000001) / 1e6 - 0.5) * 3; };
  const auto anywhere = [&] { return glm::dvec3(number(), number(), number()); };
  int hits = 0;
  for (int i = 0; i < 1000; ++i) {
    const glm::dvec3 from = anywhere(), to = anywhere();
    const double expected = nearestByAll(*mesh, from, to);
    const auto hit = tree.first(from, to);
    ASSERT_EQ(hit.has_value(), expected < 2);
    if (!hit) continue;
    ++hits;
    EXPECT_NEAR(glm::distance(hit->point, from + expected * (to - from)), 0, 1e-9);
  }
  EXPECT_GT(hits, 40);
}

TEST(TriangleTree, LetsNoRayOutBetweenNeighbours) {
  const auto mesh = test::sampleMesh("cube", 3000);
  const TriangleTree tree(mesh);
  const glm::dvec3 inside(0.013, -0.021, 0.034);
  const auto p = mesh->positions();
  for (const auto& [a, b, c] : mesh->triangles()) {
    for (const glm::dvec3& place : {p[a], (p[a] + p[b]) / 2.0, (p[a] + 2.0 * p[c]) / 3.0}) {
      ASSERT_TRUE(tree.first(inside, inside + 3.0 * (place - inside)).has_value());
    }
  }
}

TEST(TriangleTree, LeavesOutWhatDoesNotCount) {
  const auto mesh = test::sampleMesh("cube", 1200);
  const TriangleTree tree(mesh);
  const glm::dvec3 from(0.01, 0.02, 5), to(0.01, 0.02, -5);
  const auto front = tree.first(from, to);
  ASSERT_TRUE(front);
  const auto back = tree.first(from, to, [&](Index t) {
    const auto& [a, b, c] = mesh->triangles()[t];
    return mesh->positions()[a].z + mesh->positions()[b].z + mesh->positions()[c].z < 0;
  });
  ASSERT_TRUE(back);
  EXPECT_NEAR(front->point.z, -back->point.z, 1e-9);
  EXPECT_FALSE(tree.first(from, to, [](Index) { return false; }));
}

TEST(TriangleTree, ARayWithoutLengthMeetsNothing) {
  const TriangleTree tree(test::sampleMesh("cube", 12));
  EXPECT_FALSE(tree.first(glm::dvec3(0), glm::dvec3(0)));
}

}  // namespace
}  // namespace chartflood
