// Fewer triangles in place of a mesh's: how many, where, and what stays apart.

#include "render/scene/simple_surface.h"

#include <set>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "core/base/rng.h"
#include "core/gauss/sector_normals.h"
#include "render/scene/packed_normal.h"
#include "tests/render/shapes.h"
#include "tests/support/test_meshes.h"

namespace chartflood {
namespace {

glm::dvec3 placeOf(const SurfaceVertices& list, std::size_t corner) {
  const auto& place = list.vertices[list.indices[corner]].place;
  return {place[0], place[1], place[2]};
}

TEST(PackedNormal, ComesBack) {
  for (const glm::vec3& n : {glm::vec3(1, 0, 0), glm::vec3(0, -1, 0), glm::vec3(0.6f, 0, -0.8f),
                             glm::vec3(-0.48f, 0.6f, 0.64f)}) {
    EXPECT_LT(glm::length(unpackNormal(packNormal(n)) - n), 0.003f);
  }
}

TEST(SimpleSurface, HasAboutAsManyTrianglesAsWantedInTheirPlaces) {
  for (const char* sample : {"bumps", "torus", "rocket"}) {
    const auto mesh = test::sampleMesh(sample, 60'000);
    const auto normals = computeCornerNormals(*mesh, 45);
    const auto simple = simpleSurface(*mesh, *surfaceVertices(*mesh, &normals), nullptr, 6000);
    const SurfaceVertices& surface = simple->surface;
    EXPECT_GT(simple->triangles.size(), 3000u) << sample;
    EXPECT_LT(simple->triangles.size(), 9000u) << sample;
    EXPECT_TRUE(surface.hasNormals);
    EXPECT_TRUE(surface.texture.empty());
    ASSERT_EQ(surface.indices.size(), 3 * simple->triangles.size());
    const std::set<Index> stoodFor(simple->triangles.begin(), simple->triangles.end());
    EXPECT_EQ(stoodFor.size(), simple->triangles.size());
    for (std::size_t c = 0; c < surface.indices.size(); ++c) {
      ASSERT_LT(surface.indices[c], surface.vertices.size());
      const Index vertex = mesh->triangles()[simple->triangles[c / 3]][c % 3];
      // No farther than across a cell.
      ASSERT_LT(glm::length(placeOf(surface, c) - mesh->positions()[vertex]),
                1.74 * simple->detail);
    }
  }
}

TEST(SimpleSurface, KeepsCreasesSharp) {
  const auto cube = test::cube(60);
  const auto normals = computeCornerNormals(*cube, 45);
  const auto simple = simpleSurface(*cube, *surfaceVertices(*cube, &normals), nullptr, 1200);
  ASSERT_FALSE(simple->empty());
  for (std::size_t c = 0; c < simple->surface.indices.size(); ++c) {
    const glm::vec3 normal =
        unpackNormal(simple->surface.vertices[simple->surface.indices[c]].normal);
    const Index t = simple->triangles[c / 3];
    EXPECT_GT(glm::dot(normal, normals.normal[3 * t + c % 3]), 0.99f);
  }
}

TEST(SimpleSurface, IsLitByNormalsThatFitItsTriangles) {
  // Small folds: each vertex is moved along the surface as far as the next ones are.
  const auto mesh = test::sampleMesh("bumps", 40'000);
  InputMesh input = test::copyInput(*mesh);
  Rng rng(1);
  for (glm::dvec3& p : input.positions) {
    for (int axis = 0; axis < 3; ++axis) {
      p[axis] += 1e-5 * mesh->scale() * (rng.below(401) - 200.0);
    }
  }
  const auto rough = test::rebuild(std::move(input));
  const auto normals = computeCornerNormals(*rough, 45);
  const auto simple = simpleSurface(*rough, *surfaceVertices(*rough, &normals), nullptr, 4000);
  const SurfaceVertices& surface = simple->surface;
  std::size_t against = 0;
  for (std::size_t c = 0; c < surface.indices.size(); ++c) {
    const std::size_t t = c / 3 * 3;
    const glm::dvec3 plane = glm::cross(placeOf(surface, t + 1) - placeOf(surface, t),
                                        placeOf(surface, t + 2) - placeOf(surface, t));
    const glm::dvec3 normal(unpackNormal(surface.vertices[surface.indices[c]].normal));
    if (glm::dot(plane, normal) < 0) ++against;
  }
  EXPECT_LT(static_cast<double>(against), 0.002 * static_cast<double>(surface.indices.size()));
}

TEST(SimpleSurface, KeepsIslandsOfTheTextureApart) {
  const auto plate = test::plate(80, 40);
  std::vector<glm::vec2> uv;
  for (Index t = 0; t < plate->triangleCount(); ++t) {
    const float island = t / 2 % 80 < 40 ? 0 : 10;
    for (const Index v : plate->triangles()[t]) {
      uv.push_back(glm::vec2(plate->positions()[v]) + glm::vec2(island, 0));
    }
  }
  const UvLayout layout = uvLayout(*plate, uv);
  ASSERT_EQ(layout.firstTriangle.size(), 2u);
  const auto simple = simpleSurface(*plate, *surfaceVertices(*plate, nullptr), &layout, 600);
  ASSERT_FALSE(simple->empty());
  ASSERT_EQ(simple->surface.texture.size(), simple->surface.vertices.size());
  for (std::size_t c = 0; c < simple->surface.indices.size(); ++c) {
    const Index t = simple->triangles[c / 3];
    const glm::dvec2 expected =
        glm::dvec2(placeOf(simple->surface, c)) + glm::dvec2(t / 2 % 80 < 40 ? 0 : 10, 0);
    const glm::dvec2 texture(simple->surface.texture[simple->surface.indices[c]]);
    // Beside the seam the corners of one island are in the middle of their half of the cell.
    EXPECT_LT(glm::length(texture - expected), simple->detail);
  }
}

TEST(SimpleSurface, KeepsWhatIsThinnerThanACell) {
  // A plate of two triangles a square, and beside it a strip of a thousandth of its width.
  InputMesh input = test::copyInput(*test::plate(80, 40));
  const auto first = static_cast<Index>(input.positions.size());
  const std::size_t plate = input.corners.size() / 3;
  for (Index i = 0; i <= 200; ++i) {
    input.positions.emplace_back(0.4 * i, 50, 0);
    input.positions.emplace_back(0.4 * i, 50.04, 0);
  }
  for (Index i = 0; i < 200; ++i) {
    const Index a = first + 2 * i;
    for (const Index corner : {a, a + 2, a + 3, a, a + 3, a + 1}) input.corners.push_back(corner);
  }
  const auto mesh = test::rebuild(std::move(input));
  ASSERT_EQ(mesh->triangleCount(), plate + 400);
  const auto simple = simpleSurface(*mesh, *surfaceVertices(*mesh, nullptr), nullptr, 600);
  std::size_t ofStrip = 0;
  for (const Index t : simple->triangles) ofStrip += t >= plate ? 1 : 0;
  EXPECT_EQ(ofStrip, 400u);
  EXPECT_GT(simple->triangles.size(), 700u);
  // With cells larger than all of it, the whole would stay: that is no simple surface.
  EXPECT_TRUE(simpleSurface(*mesh, *surfaceVertices(*mesh, nullptr), nullptr, 1)->empty());
}

TEST(SimpleSurface, IsEmptyWithoutArea) {
  const auto mesh = test::meshOf({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}});
  EXPECT_TRUE(simpleSurface(*mesh, *surfaceVertices(*mesh, nullptr), nullptr, 100)->empty());
}

}  // namespace
}  // namespace chartflood
