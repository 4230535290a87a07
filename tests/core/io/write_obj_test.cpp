// OBJ files: the input comes back bit for bit, and texture coordinates are cut where charts are.

#include "core/io/write/write_obj.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include "core/base/parallel.h"
#include "core/charts/chart_surface.h"
#include "export_support.h"
#include "io_support.h"
#include "tests/support/test_meshes.h"

namespace chartflood::test {
namespace {

using Pair = std::pair<Index, Index>;

bool sameBits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

/// The reader of the program gives back exactly what it gave before.
void expectTheInputAgain(const Charted& charted) {
  const InputMesh& before = charted.mesh->input();
  const auto after = readBytes("again.obj", objText(charted.view()));
  ASSERT_EQ(after->positions.size(), before.positions.size());
  for (std::size_t v = 0; v < before.positions.size(); ++v) {
    for (int axis = 0; axis < 3; ++axis) {
      ASSERT_TRUE(sameBits(after->positions[v][axis], before.positions[v][axis])) << v;
    }
  }
  EXPECT_EQ(facesOf(*after), facesOf(before));
  EXPECT_EQ(after->repairs.size(), 0u) << after->repairs.front().text;
}

TEST(WriteObj, GivesTheInputBackBitForBit) {
  expectTheInputAgain(inPatches(quadCube(), 1));
  expectTheInputAgain(inPatches(sampleMesh("rocket", 3000), 100));
  expectTheInputAgain(inPatches(oddMesh(), 3));
  expectTheInputAgain(inPatches(sampleMesh("gear", 40000), 5000));
}

TEST(WriteObj, GivesRealMeshesBackBitForBit) {
  for (const char* file : {"greek-helmet-quads.obj", "duck.glb", "bracket-3.stl", "suzanne.obj",
                           "screwdriver-bigendian.ply"}) {
    const auto mesh = realMesh(file);
    if (mesh == nullptr) GTEST_SKIP() << "no real meshes at hand";
    expectTheInputAgain(inPatches(mesh, mesh->faceCount() / 10));
  }
}

TEST(WriteObj, EveryFaceStandsUnderItsChart) {
  const Charted cube = chartedMesh(quadCube(), {0, 0, 2, 1, 1, 2});
  const ObjFile obj = parseObj(objText(cube.view()));
  EXPECT_EQ(obj.group, (std::vector<std::string>{"chart_000", "chart_000", "chart_002", "chart_001",
                                                 "chart_001", "chart_002"}));
  const std::string text = objText(cube.view());
  std::size_t switches = 0;
  for (std::size_t at = text.find("\ng "); at != std::string::npos;
       at = text.find("\ng ", at + 1)) {
    ++switches;
  }
  EXPECT_EQ(switches, 4u) << "a group begins where the chart changes and nowhere else";
}

TEST(WriteObj, NamesMoreThanAThousandCharts) {
  EXPECT_EQ(chartName(7), "chart_007");
  EXPECT_EQ(chartName(999), "chart_999");
  EXPECT_EQ(chartName(1234), "chart_1234");
}

TEST(WriteObj, TextureCoordinatesAreThoseOfTheAtlas) {
  const Charted cube = inPatches(quadCube(), 1);
  const ObjFile obj = parseObj(objText(cube.view()));
  ASSERT_EQ(obj.texture.size(), 24u);
  for (Index face = 0; face < 6; ++face) {
    const ChartSurface& surface = cube.charts.charts[face].surface;
    ASSERT_EQ(obj.faces[face].size(), 4u);
    for (const ObjCorner& corner : obj.faces[face]) {
      const auto at =
          std::find(surface.meshVertex.begin(), surface.meshVertex.end(), corner.vertex);
      ASSERT_NE(at, surface.meshVertex.end());
      const std::size_t local = static_cast<std::size_t>(at - surface.meshVertex.begin());
      EXPECT_EQ(obj.texture[corner.texture], cube.atlas.uv[face][local]);
    }
  }
}

TEST(WriteObj, TextureCoordinatesDifferAcrossChartBordersAndNowhereElse) {
  for (const auto& mesh : {grid(12, false), sampleMesh("rocket", 4000)}) {
    const Charted charted = inPatches(mesh, 40);
    const ObjFile obj = parseObj(objText(charted.view()));
    // Faces and texture coordinates on both sides of every edge of the file.
    struct Side {
      std::size_t face;
      std::map<Index, Index> texture;
    };
    std::map<Pair, std::vector<Side>> edges;
    for (std::size_t f = 0; f < obj.faces.size(); ++f) {
      const auto& face = obj.faces[f];
      for (std::size_t i = 0; i < face.size(); ++i) {
        const ObjCorner a = face[i], b = face[(i + 1) % face.size()];
        edges[std::minmax(a.vertex, b.vertex)].push_back(
            {f, {{a.vertex, a.texture}, {b.vertex, b.texture}}});
      }
    }
    std::size_t seams = 0, inner = 0;
    for (const auto& [edge, sides] : edges) {
      if (sides.size() != 2) continue;
      const bool seam = charted.label[sides[0].face] != charted.label[sides[1].face];
      for (const Index end : {edge.first, edge.second}) {
        const bool differs = sides[0].texture.at(end) != sides[1].texture.at(end);
        ASSERT_EQ(differs, seam) << "edge " << edge.first << " " << edge.second;
      }
      ++(seam ? seams : inner);
    }
    EXPECT_GT(seams, 10u);
    EXPECT_GT(inner, 100u);
  }
}

TEST(WriteObj, EveryChartIsADiskByItsTextureCoordinates) {
  Charted charted = inPatches(sampleMesh("sphere", 3000), 60);
  std::size_t disks = 0;
  const ObjFile obj = parseObj(objText(charted.view()));
  const auto charts = textureTopologies(obj);
  ASSERT_EQ(charts.size(), charted.charts.charts.size());
  std::map<Index, std::set<Index>> verticesOf;
  for (const auto& face : obj.faces) {
    for (const ObjCorner& corner : face) verticesOf[corner.texture].insert(corner.vertex);
  }
  EXPECT_EQ(verticesOf.size(), obj.texture.size()) << "a texture coordinate is not used";
  for (const auto& entry : verticesOf) EXPECT_EQ(entry.second.size(), 1u);
  for (const auto& [name, chart] : charts) {
    const std::size_t number = static_cast<std::size_t>(std::stoul(name.substr(6)));
    const ChartTopology expected = charted.charts.charts[number].topology;
    EXPECT_EQ(chart.euler(), expected.euler) << name;
    disks += expected.disk() && chart.boundaryLoops() == 1 ? 1 : 0;
  }
  EXPECT_GT(disks, charts.size() / 2);
}

TEST(WriteObj, CutsPartTextureCoordinates) {
  const auto tube = sampleMesh("tube", 800);
  Charted charted = chartedMesh(tube, std::vector<Index>(tube->faceCount(), 0));
  auto before = textureTopologies(parseObj(objText(charted.view())));
  EXPECT_EQ(before["chart_000"].euler(), 0);
  EXPECT_EQ(before["chart_000"].boundaryLoops(), 2u);
  // From one rim to the other: the shortest way over edges.
  const std::vector<std::vector<Index>> loops = boundaryLoops(charted.charts.charts[0].surface);
  std::vector<Index> from(tube->vertexCount(), kNone), queue;
  std::set<Index> target;
  for (const Index side : loops[1]) target.insert(tube->sideStart(side));
  for (const Index side : loops[0]) {
    queue.push_back(tube->sideStart(side));
    from[queue.back()] = 3 * static_cast<Index>(tube->triangleCount());
  }
  Index reached = kNone;
  for (std::size_t q = 0; q < queue.size() && reached == kNone; ++q) {
    for (Index side = 0; side < tube->opposite().size(); ++side) {
      const Index end = tube->sideEnd(side);
      if (tube->sideStart(side) != queue[q] || tube->opposite()[side] == kNone) continue;
      if (from[end] != kNone) continue;
      from[end] = side;
      queue.push_back(end);
      if (target.contains(end)) reached = end;
    }
  }
  ASSERT_NE(reached, kNone);
  std::vector<Index> path;
  for (Index v = reached; from[v] < tube->opposite().size(); v = tube->sideStart(from[v])) {
    path.push_back(from[v]);
  }
  cutAlong(charted, 0, path);
  auto after = textureTopologies(parseObj(objText(charted.view())));
  EXPECT_EQ(after["chart_000"].euler(), 1);
  EXPECT_EQ(after["chart_000"].boundaryLoops(), 1u);
  EXPECT_EQ(after["chart_000"].points.size(), before["chart_000"].points.size() + path.size() + 1);
  expectTheInputAgain(charted);
}

TEST(WriteObj, KeepsDroppedFacesInTheirPlace) {
  const Charted odd = inPatches(oddMesh(), 2);
  const ObjFile obj = parseObj(objText(odd.view()));
  ASSERT_EQ(obj.faces.size(), 10u);
  for (const std::size_t face : {1u, 7u}) {
    EXPECT_EQ(obj.group[face], "dropped");
    for (const ObjCorner& corner : obj.faces[face]) EXPECT_EQ(corner.texture, kNone);
  }
  for (const std::size_t face : {0u, 2u, 3u, 4u, 5u, 6u, 8u, 9u}) {
    EXPECT_TRUE(obj.group[face].starts_with("chart_")) << face;
    for (const ObjCorner& corner : obj.faces[face]) EXPECT_LT(corner.texture, obj.texture.size());
  }
  // A corner that is listed twice has one texture coordinate.
  EXPECT_EQ(obj.faces[4][0].texture, obj.faces[4][1].texture);
  EXPECT_EQ(obj.faces[6][4].texture, obj.faces[6][5].texture);
  // The spike ends where it began.
  EXPECT_EQ(obj.faces[5][1].texture, obj.faces[5][0].texture);
  EXPECT_EQ(obj.faces[5][2].texture, obj.faces[5][0].texture);
}

TEST(WriteObj, CornersOutsideOfTrianglesTakeTheTextureOfTheirVertex) {
  // The last corner is the first again, and lies behind another one.
  const auto mesh = meshOf({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}, {{0, 1, 2, 0}});
  const ObjFile obj = parseObj(objText(inPatches(mesh, 1).view()));
  ASSERT_EQ(obj.faces[0].size(), 4u);
  EXPECT_EQ(obj.faces[0][3].texture, obj.faces[0][0].texture);
  EXPECT_EQ(obj.texture.size(), 3u);
}

TEST(WriteObj, TellsDroppedFacesFromThoseWithoutChart) {
  const auto odd = oddMesh();
  const ObjFile obj =
      parseObj(objText(chartedMesh(odd, std::vector<Index>(odd->faceCount(), kNone)).view()));
  for (std::size_t f = 0; f < obj.faces.size(); ++f) {
    EXPECT_EQ(obj.group[f], f == 1 || f == 7 ? "dropped" : "free");
  }
}

TEST(WriteObj, FacesWithoutChartAndChartsNotLaidFlatHaveNoTexture) {
  Charted charted = chartedMesh(grid(3, false), {0, 0, 0, 1, 1, 1, 1, kNone, kNone});
  charted.atlas.uv[0].clear();
  const ObjFile obj = parseObj(objText(charted.view()));
  for (std::size_t f = 0; f < obj.faces.size(); ++f) {
    const bool textured = charted.label[f] == 1;
    EXPECT_EQ(obj.group[f] == "free", charted.label[f] == kNone);
    for (const ObjCorner& c : obj.faces[f]) EXPECT_EQ(c.texture < obj.texture.size(), textured);
  }
  EXPECT_EQ(obj.texture.size(), charted.atlas.uv[1].size());
  expectTheInputAgain(charted);
  charted.atlas.uv.clear();
  EXPECT_EQ(parseObj(objText(charted.view())).texture.size(), 0u);
  expectTheInputAgain(charted);
}

TEST(WriteObj, JoinedVerticesKeepTheirNumbers) {
  // Two triangles of an STL: six vertices in the file's order, of which two pairs coincide.
  std::string stl(80, ' ');
  stl += bytesOf(std::uint32_t{2});
  for (const auto& p :
       {std::array{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}) {
    if (stl.size() == 84 || stl.size() == 134) stl += std::string(12, '\0');
    for (const int x : p) stl += bytesOf(static_cast<float>(x));
    if (stl.size() == 132 || stl.size() == 182) stl += std::string(2, '\0');
  }
  const Charted charted = inPatches(buildBytes("two.stl", stl), 10);
  expectTheInputAgain(charted);
  InputMesh unshared = copyInput(*sampleMesh("sphere", 500));
  std::vector<glm::dvec3> corners;
  for (const Index v : unshared.corners) corners.push_back(unshared.positions[v]);
  std::iota(unshared.corners.begin(), unshared.corners.end(), Index{0});
  unshared.positions = corners;
  const Charted welded = inPatches(rebuild(unshared), 20);
  const ObjFile obj = parseObj(objText(welded.view()));
  ASSERT_EQ(obj.vertices.size(), corners.size());
  Index corner = 0;
  for (const auto& face : obj.faces) {
    for (const ObjCorner& c : face) EXPECT_EQ(c.vertex, corner++);
  }
  std::size_t places = 0;
  for (const auto& uv : welded.atlas.uv) places += uv.size();
  EXPECT_EQ(obj.texture.size(), places) << "joined corners share their texture coordinate";
}

TEST(WriteObj, GivesEachChartAMaterialWhenAsked) {
  const Charted cube = chartedMesh(quadCube(), {0, 0, 2, 1, 1, 2});
  ObjOptions options;
  options.materialFile = "cube.mtl";
  const std::string text = objText(cube.view(), options);
  EXPECT_TRUE(text.starts_with("mtllib cube.mtl\n"));
  const ObjFile obj = parseObj(text);
  EXPECT_EQ(obj.material, obj.group);
  EXPECT_EQ(objText(cube.view()).find("mtl"), std::string::npos);
  const std::vector<std::uint32_t> colors{0xFF8000, 0x000000};
  const std::string materials = materialText(colors);
  EXPECT_TRUE(
      materials.starts_with("newmtl chart_000\nKd 1 0.502 0\nnewmtl chart_001\nKd 0 0 0\n"));
}

TEST(WriteObj, IsTheSameForAnyNumberOfThreads) {
  const Charted charted = inPatches(sampleMesh("rocket", 60000), 3000);
  setThreadCount(1);
  const std::string one = objText(charted.view());
  setThreadCount(3);
  const std::string three = objText(charted.view());
  setThreadCount(0);
  EXPECT_TRUE(one == three);
}

}  // namespace
}  // namespace chartflood::test
