// Vertices as the graphics card gets them: shared where corners agree, parted where they do not.

#include "render/scene/surface_vertices.h"

#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "core/gauss/sector_normals.h"
#include "tests/support/test_meshes.h"

namespace chartflood {

namespace {

glm::vec3 cornerPlace(const SurfaceVertices& list, std::size_t corner) {
  const auto& place = list.vertices[list.indices[corner]].place;
  return {place[0], place[1], place[2]};
}

TEST(SurfaceVertices, AreOneAVertexWithoutNormals) {
  const auto mesh = test::sampleMesh("torus", 600);
  const auto list = surfaceVertices(*mesh, nullptr);
  EXPECT_FALSE(list->hasNormals);
  EXPECT_TRUE(list->texture.empty());
  EXPECT_EQ(list->vertices.size(), mesh->vertexCount());
  ASSERT_EQ(list->indices.size(), 3 * mesh->triangleCount());
  for (std::size_t c = 0; c < list->indices.size(); ++c) {
    EXPECT_EQ(cornerPlace(*list, c), glm::vec3(mesh->positions()[mesh->triangles()[c / 3][c % 3]]));
  }
}

TEST(SurfaceVertices, ArePartedWhereTexturePlacesDiffer) {
  const auto mesh = test::sampleMesh("torus", 600);
  const CornerNormals normals = computeCornerNormals(*mesh, 45);
  const auto whole = surfaceVertices(*mesh, &normals);
  // One island of all triangles but the first, which is one of its own.
  std::vector<glm::vec3> corners;
  for (std::size_t c = 0; c < whole->indices.size(); ++c) {
    const float island = c < 3 ? 100.0f : 0.0f;
    corners.emplace_back(island + static_cast<float>(whole->indices[c]), 0.5f, 1.0f);
  }
  const auto parted = partedVertices(*whole, corners);
  EXPECT_TRUE(parted->hasNormals);
  EXPECT_EQ(parted->vertices.size(), whole->vertices.size() + 3);
  ASSERT_EQ(parted->texture.size(), parted->vertices.size());
  ASSERT_EQ(parted->indices.size(), whole->indices.size());
  for (std::size_t c = 0; c < corners.size(); ++c) {
    EXPECT_EQ(parted->texture[parted->indices[c]], corners[c]);
    EXPECT_EQ(cornerPlace(*parted, c), cornerPlace(*whole, c));
    EXPECT_EQ(parted->vertices[parted->indices[c]].normal,
              whole->vertices[whole->indices[c]].normal);
  }
  const std::set<Index> used(parted->indices.begin(), parted->indices.end());
  EXPECT_EQ(used.size(), parted->vertices.size()) << "no vertex is left over";
}

}  // namespace

}  // namespace chartflood
