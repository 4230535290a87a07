// GLB files: taken apart by the container's definition and by the program's own reader.

#include "core/io/write/write_glb.h"

#include <array>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cstdint>
#include <cstring>
#include <map>
#include <set>
#include <utility>

#include <glm/geometric.hpp>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "export_support.h"
#include "io_support.h"
#include "tests/support/test_meshes.h"

namespace chartflood::test {
namespace {

using nlohmann::json;

struct GlbFile {
  json scene;
  std::string buffer;
  bool wellFormed = false;

  const json& primitive() const { return scene["meshes"][0]["primitives"][0]; }
  bool has(const char* attribute) const { return primitive()["attributes"].contains(attribute); }
  template <class T>
  std::vector<T> values(int accessor) const {
    const json& entry = scene["accessors"][static_cast<std::size_t>(accessor)];
    const json& view = scene["bufferViews"][entry["bufferView"].get<std::size_t>()];
    std::vector<T> out(entry["count"].get<std::size_t>());
    EXPECT_EQ(view["byteLength"].get<std::size_t>(), out.size() * sizeof(T));
    EXPECT_EQ(view["byteOffset"].get<std::size_t>() % 4, 0u);
    std::memcpy(out.data(), buffer.data() + view["byteOffset"].get<std::size_t>(),
                out.size() * sizeof(T));
    return out;
  }
  template <class T>
  std::vector<T> attribute(const char* name) const {
    return values<T>(primitive()["attributes"][name].get<int>());
  }
  std::vector<std::uint32_t> corners() const {
    return values<std::uint32_t>(primitive()["indices"].get<int>());
  }
};

GlbFile parseGlb(const std::string& bytes) {
  GlbFile out;
  ByteReader in(bytes);
  const bool magic = in.take<std::uint32_t>() == 0x46546C67;
  const bool version = in.take<std::uint32_t>() == 2;
  const bool length = in.take<std::uint32_t>() == bytes.size();
  const std::size_t jsonLength = in.take<std::uint32_t>();
  const bool isJson = in.take<std::uint32_t>() == 0x4E4F534A;
  out.scene = json::parse(bytes.substr(20, jsonLength));
  in = ByteReader(std::string_view(bytes).substr(20 + jsonLength));
  const std::size_t bufferLength = in.take<std::uint32_t>();
  const bool isBuffer = in.take<std::uint32_t>() == 0x004E4942;
  out.buffer = bytes.substr(28 + jsonLength);
  out.wellFormed = magic && version && length && isJson && isBuffer && jsonLength % 4 == 0 &&
                   bufferLength == out.buffer.size() && bufferLength % 4 == 0 &&
                   out.scene["buffers"][0]["byteLength"] == bufferLength;
  return out;
}

/// The triangles of the file by position, chart by chart, and what the mesh says of them.
void expectTheChartsOf(const Charted& charted, const GlbFile& glb) {
  ASSERT_TRUE(glb.wellFormed);
  const auto position = glb.attribute<glm::vec3>("POSITION");
  const auto texture = glb.attribute<glm::vec2>("TEXCOORD_0");
  const auto chart = glb.attribute<float>("_CHART");
  const auto corners = glb.corners();
  ASSERT_EQ(corners.size(), 3 * charted.mesh->triangleCount());
  std::size_t next = 0, vertices = 0;
  for (std::size_t c = 0; c < charted.charts.charts.size(); ++c) {
    const ChartSurface& s = charted.charts.charts[c].surface;
    vertices += s.vertexCount();
    for (std::size_t t = 0; t < s.triangleCount(); ++t) {
      const bool turned = charted.mesh->turned(charted.mesh->faceOf(s.meshTriangle[t]));
      for (const std::size_t i : turned ? std::array{0u, 2u, 1u} : std::array{0u, 1u, 2u}) {
        const std::uint32_t v = corners[next++];
        const Index meshVertex = charted.mesh->triangles()[s.meshTriangle[t]][i];
        const Index inputVertex = charted.mesh->inputVertex(meshVertex);
        ASSERT_EQ(position[v], glm::vec3(charted.mesh->input().positions[inputVertex]));
        ASSERT_EQ(chart[v], static_cast<float>(c));
        const glm::dvec2 uv = charted.atlas.uv[c][s.triangles[t][i]];
        ASSERT_EQ(texture[v], glm::vec2(glm::dvec2(uv.x, 1 - uv.y)));
      }
    }
  }
  EXPECT_EQ(position.size(), vertices) << "vertices are split at seams and nowhere else";
}

TEST(WriteGlb, HoldsTheChartsOfTheMesh) {
  for (const auto& mesh : {quadCube(), sampleMesh("rocket", 4000), sampleMesh("gear", 4000)}) {
    const Charted charted = inPatches(mesh, 50);
    expectTheChartsOf(charted, parseGlb(glbBytes(charted.view())));
  }
}

TEST(WriteGlb, ReadsAgainAsTheSameTriangles) {
  const Charted charted = inPatches(sampleMesh("rocket", 4000), 50);
  const auto again = readBytes("again.glb", glbBytes(charted.view()));
  std::multiset<std::vector<double>> before, after;
  const auto flat = [](const InputMesh& mesh, std::size_t f) {
    std::vector<double> values;
    for (const Index v : mesh.face(f)) {
      for (int axis = 0; axis < 3; ++axis) {
        values.push_back(static_cast<float>(mesh.positions[v][axis]));
      }
    }
    return values;
  };
  for (std::size_t f = 0; f < again->faceCount(); ++f) {
    before.insert(flat(charted.mesh->input(), f));
    after.insert(flat(*again, f));
  }
  EXPECT_EQ(before, after);
  const auto mesh = rebuild(*again);
  EXPECT_EQ(mesh->boundaryLoopCount(), charted.mesh->boundaryLoopCount()) << "seams join again";
}

TEST(WriteGlb, TellsTheBoundsOfPositionsExactly) {
  const Charted charted = inPatches(sampleMesh("rocket", 3000), 50);
  const GlbFile glb = parseGlb(glbBytes(charted.view()));
  const json& accessor =
      glb.scene["accessors"][glb.primitive()["attributes"]["POSITION"].get<std::size_t>()];
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double low = 1e9, high = -1e9;
    for (const glm::vec3& p : glb.attribute<glm::vec3>("POSITION")) {
      low = std::min(low, static_cast<double>(p[static_cast<int>(axis)]));
      high = std::max(high, static_cast<double>(p[static_cast<int>(axis)]));
    }
    EXPECT_EQ(accessor["min"][axis].get<double>(), low);
    EXPECT_EQ(accessor["max"][axis].get<double>(), high);
  }
}

TEST(WriteGlb, NormalsAreSmoothOverSeamsAndSharpAtCreases) {
  const Charted sphere = inPatches(sampleMesh("sphere", 4000), 100);
  const GlbFile round = parseGlb(glbBytes(sphere.view()));
  const auto position = round.attribute<glm::vec3>("POSITION");
  const auto normal = round.attribute<glm::vec3>("NORMAL");
  std::map<std::vector<float>, glm::vec3> first;
  for (std::size_t v = 0; v < position.size(); ++v) {
    EXPECT_NEAR(glm::length(normal[v]), 1, 1e-5);
    EXPECT_GT(glm::dot(normal[v], glm::normalize(position[v])), 0.999f) << "the sphere's own";
    const glm::vec3& p = position[v];
    const auto seen = first.try_emplace({p.x, p.y, p.z}, normal[v]).first;
    EXPECT_LT(glm::length(seen->second - normal[v]), 1e-5) << "a seam shows";
  }
  const Charted cube = inPatches(quadCube(), 1);
  const GlbFile sharp = parseGlb(glbBytes(cube.view()));
  const auto corners = sharp.corners();
  const auto at = sharp.attribute<glm::vec3>("POSITION");
  const auto up = sharp.attribute<glm::vec3>("NORMAL");
  for (std::size_t t = 0; t < corners.size(); t += 3) {
    const glm::vec3 flat = glm::normalize(
        glm::cross(at[corners[t + 1]] - at[corners[t]], at[corners[t + 2]] - at[corners[t]]));
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_LT(glm::length(up[corners[t + i]] - flat), 1e-5);
    }
  }
}

TEST(WriteGlb, KeepsFacesWithoutChartAndChartsNotLaidFlat) {
  Charted charted = chartedMesh(grid(3, false), {0, 0, 0, 1, 1, 1, 1, kNone, kNone});
  charted.atlas.uv[0].clear();
  const GlbFile some = parseGlb(glbBytes(charted.view()));
  ASSERT_TRUE(some.wellFormed);
  EXPECT_EQ(some.corners().size(), 3 * charted.mesh->triangleCount());
  const auto chart = some.attribute<float>("_CHART");
  EXPECT_EQ(std::set<float>(chart.begin(), chart.end()), (std::set<float>{-1, 0, 1}));
  charted.atlas.uv.clear();
  const GlbFile none = parseGlb(glbBytes(charted.view()));
  EXPECT_FALSE(none.has("TEXCOORD_0"));
  EXPECT_EQ(none.attribute<float>("_CHART"), chart);
}

TEST(WriteGlb, WritesOddMeshes) {
  const Charted odd = inPatches(oddMesh(), 2);
  const GlbFile glb = parseGlb(glbBytes(odd.view()));
  expectTheChartsOf(odd, glb);
  for (const glm::vec3& n : glb.attribute<glm::vec3>("NORMAL")) {
    EXPECT_NEAR(glm::length(n), 1, 1e-5);
  }
}

TEST(WriteGlb, RefusesWhatSinglePrecisionCannotHold) {
  const auto huge = meshOf({{0, 0, 0}, {1e300, 0, 0}, {0, 1e300, 0}}, {{0, 1, 2}});
  try {
    glbBytes(inPatches(huge, 1).view());
    FAIL() << "no refusal";
  } catch (const Error& e) {
    EXPECT_NE(std::string(e.what()).find("too large"), std::string::npos) << e.what();
  }
}

TEST(WriteGlb, EmbedsATextureWhenGiven) {
  const Charted cube = inPatches(quadCube(), 1);
  const GlbFile glb = parseGlb(glbBytes(cube.view(), {45, "not really a PNG file"}));
  ASSERT_TRUE(glb.wellFormed);
  const json& view =
      glb.scene["bufferViews"][glb.scene["images"][0]["bufferView"].get<std::size_t>()];
  EXPECT_EQ(glb.buffer.substr(view["byteOffset"].get<std::size_t>(),
                              view["byteLength"].get<std::size_t>()),
            "not really a PNG file");
  EXPECT_EQ(glb.scene["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["index"], 0);
  EXPECT_FALSE(parseGlb(glbBytes(cube.view())).scene.contains("images"));
}

TEST(WriteGlb, IsTheSameForAnyNumberOfThreads) {
  const Charted charted = inPatches(sampleMesh("rocket", 60000), 3000);
  setThreadCount(1);
  const std::string one = glbBytes(charted.view());
  setThreadCount(3);
  const std::string three = glbBytes(charted.view());
  setThreadCount(0);
  EXPECT_TRUE(one == three);
}

}  // namespace
}  // namespace chartflood::test
