// Gluing and repairing: core/model/build_mesh.

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "tests/support/test_meshes.h"

namespace chartflood {
namespace {

using test::meshOf;
using test::repairCount;

const std::vector<glm::dvec3> kTetrahedron = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
const test::Polygons kTetrahedronFaces = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};

void expectConsistent(const Mesh& mesh) {
  const auto opposite = mesh.opposite();
  for (Index s = 0; s < opposite.size(); ++s) {
    if (opposite[s] == kNone) continue;
    EXPECT_EQ(opposite[opposite[s]], s);
    EXPECT_EQ(mesh.sideStart(s), mesh.sideEnd(opposite[s]));
    EXPECT_EQ(mesh.sideEnd(s), mesh.sideStart(opposite[s]));
  }
  // Each vertex owns exactly one fan: turning from its first side meets all its corners.
  std::vector<std::size_t> corners(mesh.vertexCount(), 0);
  for (Index s = 0; s < opposite.size(); ++s) ++corners[mesh.sideStart(s)];
  for (Index v = 0; v < mesh.vertexCount(); ++v) {
    std::size_t met = 0;
    const Index first = mesh.vertexSide()[v];
    for (Index side = first; side != kNone;) {
      ++met;
      side = mesh.turn(side);
      if (side == first) break;
    }
    EXPECT_EQ(met, corners[v]) << "vertex " << v;
  }
}

TEST(BuildMesh, ClosesTetrahedron) {
  const auto mesh = meshOf(kTetrahedron, kTetrahedronFaces);
  expectConsistent(*mesh);
  EXPECT_EQ(mesh->triangleCount(), 4u);
  EXPECT_EQ(mesh->edgeCount(), 6u);
  EXPECT_EQ(mesh->boundaryLoopCount(), 0u);
  EXPECT_EQ(mesh->eulerNumber(), 2);
  EXPECT_EQ(mesh->genus(), 0);
  EXPECT_TRUE(mesh->facesAreTriangles());
  EXPECT_TRUE(mesh->repairs().empty());
}

TEST(BuildMesh, KeepsPolygonsAsFaces) {
  const auto cube = test::quadCube();
  expectConsistent(*cube);
  EXPECT_EQ(cube->faceCount(), 6u);
  EXPECT_EQ(cube->triangleCount(), 12u);
  EXPECT_EQ(cube->eulerNumber(), 2);
  EXPECT_NEAR(cube->surfaceArea() * cube->scale() * cube->scale(), 6, 1e-12);
  for (Index f = 0; f < 6; ++f) {
    EXPECT_EQ(cube->triangleBegin(f + 1) - cube->triangleBegin(f), 2u);
    EXPECT_EQ(cube->faceOf(cube->triangleBegin(f)), f);
  }
}

TEST(BuildMesh, SplitsNonManifoldEdge) {
  const auto mesh = meshOf({{0, 0, 0}, {1, 0, 0}, {0.5, 1, 0}, {0.5, -1, 0}, {0.5, 0, 1}},
                           {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}});
  expectConsistent(*mesh);
  EXPECT_EQ(repairCount(*mesh, "non-manifold-edges"), 1u);
  EXPECT_EQ(mesh->componentCount(), 3u);
  EXPECT_EQ(repairCount(*mesh, "split-vertices"), 4u);  // two vertices, two copies each
}

TEST(BuildMesh, SplitsBowTieVertex) {
  const auto mesh =
      meshOf({{0, 0, 0}, {1, 1, 0}, {1, -1, 0}, {-1, 1, 0}, {-1, -1, 0}}, {{0, 2, 1}, {0, 3, 4}});
  expectConsistent(*mesh);
  EXPECT_EQ(repairCount(*mesh, "split-vertices"), 1u);
  EXPECT_EQ(mesh->vertexCount(), 6u);
  EXPECT_EQ(mesh->inputVertex(5), 0u);
}

TEST(BuildMesh, DropsTrianglesThatRepeatACorner) {
  auto faces = kTetrahedronFaces;
  faces.insert(faces.begin() + 1, {2, 2, 2});
  faces.push_back({0, 1});
  const auto mesh = meshOf(kTetrahedron, faces);
  EXPECT_EQ(mesh->faceCount(), 4u);
  EXPECT_EQ(repairCount(*mesh, "dropped-triangles"), 1u);
  EXPECT_EQ(repairCount(*mesh, "dropped-faces"), 2u);
  EXPECT_EQ(mesh->inputFace(0), 0u);
  EXPECT_EQ(mesh->inputFace(1), 2u);
  EXPECT_EQ(mesh->closed(), true);
}

TEST(BuildMesh, GluesDiagonalsWhateverElseSharesTheirVertices) {
  // Two quads over the same four vertices: both fans use the diagonal 0-2.
  const auto mesh =
      meshOf({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2, 3}, {0, 3, 2, 1}});
  expectConsistent(*mesh);
  EXPECT_EQ(mesh->faceCount(), 2u);
  EXPECT_EQ(mesh->componentCount(), 1u);
  EXPECT_TRUE(mesh->closed());
  EXPECT_EQ(mesh->eulerNumber(), 2);
}

TEST(BuildMesh, MarksDegenerateTriangles) {
  const auto mesh =
      meshOf({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 1, 0}}, {{0, 1, 3}, {1, 2, 3}, {0, 2, 1}});
  EXPECT_EQ(repairCount(*mesh, "degenerate-triangles"), 1u);
  EXPECT_TRUE(mesh->degenerate(2));
  EXPECT_EQ(mesh->triangleCount(), 3u);
}

TEST(BuildMesh, NormalisesAnyScale) {
  for (const double scale : {1e-30, 1e-300, 1.0, 1e30, 1e200}) {
    auto positions = kTetrahedron;
    for (auto& p : positions) p *= scale;
    const auto mesh = meshOf(positions, kTetrahedronFaces);
    EXPECT_NEAR(mesh->surfaceArea(), 2.3660254037844 / 3, 1e-12) << scale;
    EXPECT_NEAR(mesh->scale() / scale, std::sqrt(3.0), 1e-12) << scale;
  }
}

TEST(BuildMesh, RefusesWhatCannotBeComputedWith) {
  auto positions = kTetrahedron;
  positions[1].x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(meshOf(positions, kTetrahedronFaces), ReadError);
  EXPECT_THROW(meshOf(kTetrahedron, {}), ReadError);
  EXPECT_THROW(meshOf(kTetrahedron, {{0, 0, 1}}), ReadError);
}

TEST(BuildMesh, CountsLoopsAndGenusOfSamples) {
  EXPECT_EQ(test::sampleMesh("torus", 2000)->genus(), 1);
  EXPECT_EQ(test::sampleMesh("double-torus", 4000)->genus(), 2);
  EXPECT_EQ(test::sampleMesh("tube", 2000)->boundaryLoopCount(), 2u);
  EXPECT_EQ(test::sampleMesh("sphere", 2000)->genus(), 0);
  expectConsistent(*test::sampleMesh("rocket", 5000));
}

}  // namespace
}  // namespace chartflood
