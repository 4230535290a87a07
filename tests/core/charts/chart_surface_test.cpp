// Charts taken out of meshes, opened along edges, and their topology.

#include "core/charts/chart_surface.h"

#include <gtest/gtest.h>

#include <numeric>
#include <vector>

#include "tests/support/test_meshes.h"

namespace chartflood {
namespace {

ChartSurface wholeMesh(const Mesh& mesh) {
  const std::vector<Index> label(mesh.faceCount(), 0);
  return extractCharts(mesh, label, 1).front();
}

TEST(ChartSurface, WholeClosedMeshesKeepTheirTopology) {
  const ChartTopology sphere = topologyOf(wholeMesh(*test::sampleMesh("sphere", 2000)));
  EXPECT_EQ(sphere.euler, 2);
  EXPECT_EQ(sphere.boundaryLoops, 0u);
  EXPECT_EQ(sphere.pieces, 1u);
  EXPECT_FALSE(sphere.disk());
  const ChartTopology torus = topologyOf(wholeMesh(*test::sampleMesh("torus", 2000)));
  EXPECT_EQ(torus.euler, 0);
  EXPECT_EQ(torus.genus(), 1);
}

TEST(ChartSurface, TheFacesOfACubeAreDisksWithoutSplitQuads) {
  const auto mesh = test::quadCube();
  std::vector<Index> label(6);
  std::iota(label.begin(), label.end(), 0);
  for (const ChartSurface& face : extractCharts(*mesh, label, 6)) {
    EXPECT_TRUE(topologyOf(face).disk());
    EXPECT_EQ(face.triangleCount(), 2u);
    EXPECT_EQ(face.vertexCount(), 4u);
    EXPECT_EQ(std::count(face.diagonal.begin(), face.diagonal.end(), true), 2);
  }
}

TEST(ChartSurface, FacesThatMeetInAVertexAloneAreApartThere) {
  // A grid of 2 x 2 quads: the two quads of one diagonal share the middle vertex.
  const auto mesh = test::grid(2, false);
  const std::vector<Index> label{0, 1, 1, 0};
  for (const ChartSurface& chart : extractCharts(*mesh, label, 2)) {
    EXPECT_EQ(chart.vertexCount(), 8u);
    EXPECT_EQ(topologyOf(chart).pieces, 2u);
  }
}

TEST(ChartSurface, OpeningAPathOnASphereMakesADisk) {
  ChartSurface surface = wholeMesh(*test::sampleMesh("sphere", 500));
  const std::size_t before = surface.vertexCount();
  // Two edges in a row around one vertex.
  const Index first = 0;
  Index second = ChartSurface::nextSide(first);
  second = ChartSurface::nextSide(surface.opposite[second]);
  ASSERT_EQ(surface.sideStart(second), surface.sideEnd(first));
  const std::vector<Index> path{first, second};
  openAlong(surface, path);
  EXPECT_EQ(surface.vertexCount(), before + 1) << "only the inner vertex of the path is doubled";
  EXPECT_TRUE(topologyOf(surface).disk());
  ASSERT_EQ(boundaryLoops(surface).size(), 1u);
  EXPECT_EQ(boundaryLoops(surface).front().size(), 4u);
  EXPECT_EQ(surface.meshVertex.back(), surface.meshVertex[surface.sideEnd(first)]);
}

TEST(ChartSurface, BoundaryLoopsRunAroundInOrder) {
  const ChartSurface tube = wholeMesh(*test::sampleMesh("tube", 1000));
  const auto loops = boundaryLoops(tube);
  ASSERT_EQ(loops.size(), 2u);
  for (const auto& loop : loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      EXPECT_EQ(tube.sideEnd(loop[i]), tube.sideStart(loop[(i + 1) % loop.size()]));
      EXPECT_EQ(tube.opposite[loop[i]], kNone);
    }
  }
}

}  // namespace
}  // namespace chartflood
