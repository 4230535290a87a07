// PLY files: charts and texture coordinates of every face, vertices of the input first.

#include "core/io/write/write_ply.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

#include "core/base/parallel.h"
#include "core/io/write/write_labels.h"
#include "core/io/write/write_obj.h"
#include "export_support.h"
#include "io_support.h"
#include "tests/support/test_meshes.h"

namespace chartflood::test {
namespace {

/// Everything that holds for both kinds of vertices.
PlyFile checkedPly(const Charted& charted, PlyVertices vertices) {
  const InputMesh& input = charted.mesh->input();
  const std::string bytes = plyBytes(charted.view(), {vertices});
  const PlyFile ply = parsePly(bytes);
  EXPECT_TRUE(ply.finished);
  EXPECT_GE(ply.vertices.size(), input.positions.size());
  for (std::size_t v = 0; v < input.positions.size(); ++v) {
    EXPECT_EQ(ply.vertices[v], input.positions[v]) << v;
  }
  // The labels are those of the label file, read by its text.
  std::string labels;
  for (const PlyFile::Face& face : ply.faces) labels += std::to_string(face.chart) + "\n";
  EXPECT_EQ(labels, labelsText(*charted.mesh, charted.label));
  // Texture coordinates are those of the OBJ file, rounded.
  const ObjFile obj = parseObj(objText(charted.view()));
  EXPECT_EQ(ply.faces.size(), obj.faces.size());
  for (std::size_t f = 0; f < ply.faces.size(); ++f) {
    const PlyFile::Face& face = ply.faces[f];
    EXPECT_EQ(face.vertices.size(), input.face(f).size());
    const bool textured = !obj.faces[f].empty() && obj.faces[f][0].texture != kNone;
    EXPECT_EQ(face.texture.size(), textured ? face.vertices.size() : 0) << f;
    for (std::size_t i = 0; i < face.vertices.size(); ++i) {
      EXPECT_EQ(ply.vertices[face.vertices[i]], input.positions[input.face(f)[i]]) << f;
      if (textured) {
        EXPECT_EQ(face.texture[i], glm::vec2(obj.texture[obj.faces[f][i].texture])) << f;
        if (!ply.texture.empty()) {
          EXPECT_EQ(ply.texture[face.vertices[i]], face.texture[i]) << f;
        }
      }
    }
  }
  return ply;
}

TEST(WritePly, RepeatsVerticesAtSeamsBehindThoseOfTheInput) {
  const Charted cube = inPatches(quadCube(), 1);
  const PlyFile ply = checkedPly(cube, PlyVertices::SplitAtSeams);
  EXPECT_EQ(ply.vertices.size(), 24u) << "every corner of the cube has three texture coordinates";
  const Charted rocket = inPatches(sampleMesh("rocket", 4000), 80);
  const PlyFile split = checkedPly(rocket, PlyVertices::SplitAtSeams);
  std::size_t places = 0;
  for (const auto& uv : rocket.atlas.uv) places += uv.size();
  EXPECT_EQ(split.vertices.size(), places);
}

TEST(WritePly, KeepsTheVerticesOfTheInputAlone) {
  const Charted rocket = inPatches(sampleMesh("rocket", 4000), 80);
  const PlyFile ply = checkedPly(rocket, PlyVertices::AsInput);
  EXPECT_EQ(ply.vertices.size(), rocket.mesh->input().positions.size());
  EXPECT_TRUE(ply.texture.empty());
  const auto again = readBytes("again.ply", plyBytes(rocket.view(), {PlyVertices::AsInput}));
  EXPECT_EQ(again->positions, rocket.mesh->input().positions);
  EXPECT_EQ(facesOf(*again), facesOf(rocket.mesh->input()));
}

TEST(WritePly, ReadsAgainAsTheSameSurface) {
  const Charted rocket = inPatches(sampleMesh("rocket", 4000), 80);
  const auto again = readBytes("again.ply", plyBytes(rocket.view()));
  ASSERT_EQ(again->faceCount(), rocket.mesh->input().faceCount());
  for (std::size_t f = 0; f < again->faceCount(); ++f) {
    for (std::size_t i = 0; i < again->face(f).size(); ++i) {
      EXPECT_EQ(again->positions[again->face(f)[i]],
                rocket.mesh->input().positions[rocket.mesh->input().face(f)[i]]);
    }
  }
}

TEST(WritePly, HoldsOddFacesInTheirPlace) {
  const Charted odd = inPatches(oddMesh(), 2);
  for (const PlyVertices vertices : {PlyVertices::SplitAtSeams, PlyVertices::AsInput}) {
    const PlyFile ply = checkedPly(odd, vertices);
    EXPECT_EQ(ply.faces[1].chart, -1);
    EXPECT_EQ(ply.faces[7].chart, -1);
    EXPECT_EQ(ply.faces[6].vertices.size(), 6u);
  }
}

TEST(WritePly, HasNoTextureWhereNoneIsKnown) {
  Charted charted = chartedMesh(grid(3, false), {0, 0, 0, 1, 1, 1, 1, kNone, kNone});
  charted.atlas.uv[0].clear();
  checkedPly(charted, PlyVertices::SplitAtSeams);
  charted.atlas.uv.clear();
  const PlyFile ply = checkedPly(charted, PlyVertices::SplitAtSeams);
  EXPECT_TRUE(ply.texture.empty());
  EXPECT_EQ(ply.vertices.size(), 16u);
}

TEST(WritePly, TakesTheSmallestNumbersThatAreExact) {
  EXPECT_NE(plyBytes(inPatches(quadCube(), 1).view()).find("property float x"), std::string::npos);
  const auto fine = meshOf({{0, 0, 0}, {0.1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
  EXPECT_NE(plyBytes(inPatches(fine, 1).view()).find("property double x"), std::string::npos);
  const auto huge = meshOf({{0, 0, 0}, {1e300, 0, 0}, {0, 1e300, 0}}, {{0, 1, 2}});
  EXPECT_NE(plyBytes(inPatches(huge, 1).view()).find("property double x"), std::string::npos);
}

TEST(WritePly, CountsInLargerNumbersForLargePolygons) {
  for (const Index corners : {127u, 128u, 300u}) {
    std::vector<glm::dvec3> points;
    std::vector<Index> face;
    for (Index i = 0; i < corners; ++i) {
      points.emplace_back(std::cos(6.28 * i / corners), std::sin(6.28 * i / corners), 0);
      face.push_back(i);
    }
    const Charted charted = inPatches(meshOf(points, {face}), 1);
    const PlyFile ply = checkedPly(charted, PlyVertices::SplitAtSeams);
    EXPECT_EQ(ply.header.find("list uchar") != std::string::npos, corners == 127) << corners;
    EXPECT_EQ(readBytes("again.ply", plyBytes(charted.view()))->face(0).size(), corners);
  }
}

TEST(WritePly, IsTheSameForAnyNumberOfThreads) {
  const Charted charted = inPatches(sampleMesh("rocket", 60000), 3000);
  setThreadCount(1);
  const std::string one = plyBytes(charted.view());
  setThreadCount(3);
  const std::string three = plyBytes(charted.view());
  setThreadCount(0);
  EXPECT_TRUE(one == three);
}

}  // namespace
}  // namespace chartflood::test
