// Compressed glTF: what the encoders of Draco and meshoptimizer made of a bumpy grid comes back,
// and what they did not make is refused with the name of the extension.

#include <cmath>
#include <cstring>

#include <draco/compression/encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>
#include <gtest/gtest.h>
#include <meshoptimizer.h>

#include "core/base/error.h"
#include "core/io/read/read_gltf.h"
#include "gltf_support.h"

namespace chartflood::test {
namespace {

using nlohmann::json;

/// 33 x 33 vertices with bumps of a tenth.
struct Grid {
  static constexpr unsigned kSide = 33;
  std::vector<glm::vec3> positions;
  std::vector<std::uint32_t> corners;

  Grid() {
    for (unsigned y = 0; y < kSide; ++y) {
      for (unsigned x = 0; x < kSide; ++x) {
        const float u = static_cast<float>(x) / 32, v = static_cast<float>(y) / 32;
        positions.emplace_back(u, v, 0.1f * std::sin(9 * u) * std::cos(7 * v));
      }
    }
    for (unsigned y = 0; y + 1 < kSide; ++y) {
      for (unsigned x = 0; x + 1 < kSide; ++x) {
        const std::uint32_t a = y * kSide + x, b = a + 1, c = a + kSide, d = c + 1;
        corners.insert(corners.end(), {a, b, d, a, d, c});
      }
    }
  }
};

double areaOf(const InputMesh& mesh) {
  double area = 0;
  for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
    const auto face = mesh.face(f);
    const glm::dvec3 a = mesh.positions[face[0]];
    area += glm::length(glm::cross(mesh.positions[face[1]] - a, mesh.positions[face[2]] - a)) / 2;
  }
  return area;
}

double areaOf(const Grid& grid) {
  InputMesh mesh;
  for (const glm::vec3& p : grid.positions) mesh.positions.emplace_back(p);
  mesh.corners.assign(grid.corners.begin(), grid.corners.end());
  return areaOf(mesh);
}

/// A scene with one node that has one mesh of one primitive.
json sceneOf(json primitive) {
  return {{"meshes", {{{"primitives", {std::move(primitive)}}}}},
          {"nodes", {{{"mesh", 0}}}},
          {"scenes", {{{"nodes", {0}}}}},
          {"scene", 0}};
}

// Draco

std::string dracoBytes(const Grid& grid, int method, int bits) {
  draco::TriangleSoupMeshBuilder builder;
  builder.Start(static_cast<int>(grid.corners.size() / 3));
  const int position =
      builder.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
  for (std::size_t f = 0; 3 * f < grid.corners.size(); ++f) {
    builder.SetAttributeValuesForFace(position, draco::FaceIndex(static_cast<std::uint32_t>(f)),
                                      &grid.positions[grid.corners[3 * f]].x,
                                      &grid.positions[grid.corners[3 * f + 1]].x,
                                      &grid.positions[grid.corners[3 * f + 2]].x);
  }
  const std::unique_ptr<draco::Mesh> mesh = builder.Finalize();
  draco::Encoder encoder;
  encoder.SetEncodingMethod(method);
  encoder.SetAttributeQuantization(draco::GeometryAttribute::POSITION, bits);
  draco::EncoderBuffer buffer;
  EXPECT_TRUE(encoder.EncodeMeshToBuffer(*mesh, &buffer).ok());
  return {buffer.data(), buffer.size()};
}

/// As exporters write it: accessors without views, the packed bytes in a view of their own.
json dracoDocument(const Grid& grid, std::size_t size) {
  json document = sceneOf(
      {{"attributes", {{"POSITION", 0}}},
       {"indices", 1},
       {"extensions",
        {{"KHR_draco_mesh_compression", {{"bufferView", 0}, {"attributes", {{"POSITION", 0}}}}}}}});
  document["accessors"] = {
      {{"componentType", 5126}, {"count", grid.positions.size()}, {"type", "VEC3"}},
      {{"componentType", 5125}, {"count", grid.corners.size()}, {"type", "SCALAR"}}};
  document["bufferViews"] = {{{"buffer", 0}, {"byteLength", size}}};
  document["buffers"] = {{{"byteLength", size}}};
  document["extensionsUsed"] = {"KHR_draco_mesh_compression"};
  document["extensionsRequired"] = {"KHR_draco_mesh_compression"};
  return document;
}

TEST(GltfDraco, ReadsBothOfItsMethods) {
  const Grid grid;
  for (const int method : {draco::MESH_SEQUENTIAL_ENCODING, draco::MESH_EDGEBREAKER_ENCODING}) {
    const std::string packed = dracoBytes(grid, method, 14);
    const auto mesh = readBytes("a.glb", glbFile(dracoDocument(grid, packed.size()), packed));
    EXPECT_EQ(mesh->positions.size(), grid.positions.size());
    EXPECT_EQ(mesh->corners.size(), grid.corners.size());
    EXPECT_NEAR(areaOf(*mesh), areaOf(grid), 1e-3);
    EXPECT_TRUE(mesh->repairs.empty());
  }
}

TEST(GltfDraco, PlacesWhatItUnpackedAtEachOfItsNodes) {
  const Grid grid;
  const std::string packed = dracoBytes(grid, draco::MESH_EDGEBREAKER_ENCODING, 14);
  json document = dracoDocument(grid, packed.size());
  document["nodes"] = {{{"mesh", 0}}, {{"mesh", 0}, {"scale", {2, 2, 2}}}};
  document["scenes"][0]["nodes"] = {0, 1};
  const auto mesh = readBytes("a.glb", glbFile(document, packed));
  EXPECT_EQ(mesh->corners.size(), 2 * grid.corners.size());
  EXPECT_NEAR(areaOf(*mesh), 5 * areaOf(grid), 1e-2);
}

TEST(GltfDraco, TakesPlainDataWhereThereAreAnyAndTheExtensionIsNotRequired) {
  const Grid grid;
  std::string data(reinterpret_cast<const char*>(grid.positions.data()),
                   grid.positions.size() * sizeof(glm::vec3));
  const std::size_t first = data.size();
  data.append(reinterpret_cast<const char*>(grid.corners.data()), grid.corners.size() * 4);
  json document = dracoDocument(grid, 10);
  document.erase("extensionsRequired");
  document["bufferViews"] = {
      {{"buffer", 0}, {"byteLength", 10}},
      {{"buffer", 0}, {"byteLength", first}},
      {{"buffer", 0}, {"byteOffset", first}, {"byteLength", data.size() - first}}};
  document["accessors"][0]["bufferView"] = 1;
  document["accessors"][1]["bufferView"] = 2;
  const auto mesh = readBytes("a.glb", glbFile(document, data));
  EXPECT_EQ(mesh->positions[40], glm::dvec3(grid.positions[40]));
}

TEST(GltfDraco, RefusesWhatItCannotUnpack) {
  const Grid grid;
  const std::string packed = dracoBytes(grid, draco::MESH_EDGEBREAKER_ENCODING, 14);
  const json document = dracoDocument(grid, packed.size());
  const auto refusal = [&](const std::string& bytes) {
    return refusalOf("a.glb", glbFile(document, bytes));
  };
  const std::string expected = "its geometry is compressed (KHR_draco_mesh_compression) and cannot "
                               "be unpacked: its data are broken or cut off";
  EXPECT_EQ(refusal(std::string(packed.size(), 'x')), expected);
  EXPECT_EQ(refusal(packed.substr(0, packed.size() / 2) + std::string(packed.size() / 2 + 1, '\0')),
            expected);
  json wrong = document;
  wrong["meshes"][0]["primitives"][0]["extensions"]["KHR_draco_mesh_compression"]["attributes"]
       ["POSITION"] = 7;
  EXPECT_NE(refusalOf("a.glb", glbFile(wrong, packed)).find("it has no positions"),
            std::string::npos);
}

/// Hostile data end in the program that unpacks them, whatever they do there.
TEST(GltfDraco, ChangedBytesAreTakenOrRefused) {
  const Grid grid;
  const std::string packed = dracoBytes(grid, draco::MESH_EDGEBREAKER_ENCODING, 8);
  const json document = dracoDocument(grid, packed.size());
  std::size_t refused = 0;
  for (std::size_t i = 0; i < 40; ++i) {
    std::string changed = packed;
    const std::size_t at = i < 20 ? i : i * 7919 % packed.size();
    changed[at] = static_cast<char>(changed[at] ^ (i % 2 == 0 ? 0xff : 0x10));
    try {
      const auto mesh = readBytes("a.glb", glbFile(document, changed));
      for (const Index corner : mesh->corners) ASSERT_LT(corner, mesh->positions.size());
    } catch (const ReadError& error) {
      EXPECT_LE(error.cause().size(), 300u);
      ++refused;
    }
  }
  EXPECT_GT(refused, 10u);
}

// meshoptimizer

struct Packed {
  std::string vertices, triangles;
};

template <class Encode>
std::string encoded(std::size_t bound, Encode encode) {
  std::string bytes(bound, '\0');
  bytes.resize(encode(reinterpret_cast<unsigned char*>(bytes.data()), bound));
  return bytes;
}

Packed meshoptBytes(const Grid& grid, bool sequence) {
  meshopt_encodeVertexVersion(0);
  meshopt_encodeIndexVersion(1);
  const std::size_t vertices = grid.positions.size(), corners = grid.corners.size();
  Packed packed;
  packed.vertices = encoded(
      meshopt_encodeVertexBufferBound(vertices, 12), [&](unsigned char* to, std::size_t size) {
        return meshopt_encodeVertexBuffer(to, size, grid.positions.data(), vertices, 12);
      });
  const std::size_t bound = sequence ? meshopt_encodeIndexSequenceBound(corners, vertices)
                                     : meshopt_encodeIndexBufferBound(corners, vertices);
  packed.triangles = encoded(bound, [&](unsigned char* to, std::size_t size) {
    return sequence ? meshopt_encodeIndexSequence(to, size, grid.corners.data(), corners)
                    : meshopt_encodeIndexBuffer(to, size, grid.corners.data(), corners);
  });
  return packed;
}

/// As gltfpack -cc writes it: a second buffer without data that the plain views would lie in.
json meshoptDocument(const Grid& grid, const Packed& packed, bool sequence) {
  json document = sceneOf({{"attributes", {{"POSITION", 0}}}, {"indices", 1}});
  const std::size_t plain = grid.positions.size() * 12, indices = grid.corners.size() * 4;
  document["accessors"] = {{{"bufferView", 0},
                            {"componentType", 5126},
                            {"count", grid.positions.size()},
                            {"type", "VEC3"}},
                           {{"bufferView", 1},
                            {"componentType", 5125},
                            {"count", grid.corners.size()},
                            {"type", "SCALAR"}}};
  const auto view = [](std::size_t plainAt, std::size_t plainSize, json how) {
    return json{{"buffer", 1},
                {"byteOffset", plainAt},
                {"byteLength", plainSize},
                {"extensions", {{"EXT_meshopt_compression", std::move(how)}}}};
  };
  document["bufferViews"] = {view(0, plain,
                                  {{"buffer", 0},
                                   {"byteLength", packed.vertices.size()},
                                   {"byteStride", 12},
                                   {"mode", "ATTRIBUTES"},
                                   {"count", grid.positions.size()}}),
                             view(plain, indices,
                                  {{"buffer", 0},
                                   {"byteOffset", packed.vertices.size()},
                                   {"byteLength", packed.triangles.size()},
                                   {"byteStride", 4},
                                   {"mode", sequence ? "INDICES" : "TRIANGLES"},
                                   {"count", grid.corners.size()}})};
  document["buffers"] = {{{"byteLength", packed.vertices.size() + packed.triangles.size()}},
                         {{"byteLength", plain + indices},
                          {"extensions", {{"EXT_meshopt_compression", {{"fallback", true}}}}}}};
  document["extensionsUsed"] = {"EXT_meshopt_compression"};
  document["extensionsRequired"] = {"EXT_meshopt_compression"};
  return document;
}

TEST(GltfMeshopt, ReadsVerticesTrianglesAndSequences) {
  const Grid grid;
  for (const bool sequence : {false, true}) {
    const Packed packed = meshoptBytes(grid, sequence);
    const auto mesh = readBytes("a.glb", glbFile(meshoptDocument(grid, packed, sequence),
                                                 packed.vertices + packed.triangles));
    ASSERT_EQ(mesh->positions.size(), grid.positions.size());
    for (std::size_t v = 0; v < grid.positions.size(); ++v) {
      ASSERT_EQ(mesh->positions[v], glm::dvec3(grid.positions[v]));
    }
    EXPECT_EQ(mesh->corners.size(), grid.corners.size());
    EXPECT_NEAR(areaOf(*mesh), areaOf(grid), 1e-12);
  }
}

TEST(GltfMeshopt, UndoesTheExponentialFilter) {
  Grid grid;
  // Mantissa 3 with exponents 0, -1 and -2: 3, 1.5 and 0.75.
  std::vector<std::uint32_t> filtered(3 * grid.positions.size());
  for (std::size_t i = 0; i < filtered.size(); ++i) {
    filtered[i] = 3u | static_cast<std::uint32_t>(256 - i % 3) << 24;
  }
  const std::size_t vertices = grid.positions.size();
  Packed packed = meshoptBytes(grid, false);
  packed.vertices = encoded(
      meshopt_encodeVertexBufferBound(vertices, 12), [&](unsigned char* to, std::size_t size) {
        return meshopt_encodeVertexBuffer(to, size, filtered.data(), vertices, 12);
      });
  json document = meshoptDocument(grid, packed, false);
  document["bufferViews"][0]["extensions"]["EXT_meshopt_compression"]["filter"] = "EXPONENTIAL";
  const auto mesh = readBytes("a.glb", glbFile(document, packed.vertices + packed.triangles));
  EXPECT_EQ(mesh->positions[5], glm::dvec3(3, 1.5, 0.75));
}

TEST(GltfMeshopt, RefusesWhatItCannotUnpack) {
  const Grid grid;
  const Packed packed = meshoptBytes(grid, false);
  const std::string data = packed.vertices + packed.triangles;
  const json document = meshoptDocument(grid, packed, false);
  const auto refusal = [&](const char* key, const json& value, const std::string& bytes) {
    json changed = document;
    json& how = changed["bufferViews"][0]["extensions"]["EXT_meshopt_compression"];
    if (*key != '\0') how[key] = value;
    const std::string words = refusalOf("a.glb", glbFile(changed, bytes));
    const std::string begin =
        "its buffer view 0 is compressed (EXT_meshopt_compression) and cannot "
        "be unpacked: ";
    EXPECT_EQ(words.substr(0, begin.size()), begin);
    return words.substr(std::min(begin.size(), words.size()));
  };
  EXPECT_EQ(refusal("", {}, std::string(data.size(), 'x')),
            "it is not of the format that the extension has");
  EXPECT_EQ(refusal("count", 2 * grid.positions.size(), data), "its data are broken or cut off");
  EXPECT_EQ(refusal("count", 4000000000u, data), "it counts more elements than it can hold");
  EXPECT_EQ(refusal("count", std::uint64_t{1} << 63, data),
            "it counts more elements than it can hold");
  EXPECT_EQ(refusal("byteStride", 13, data), "its elements are of a size that cannot be");
  EXPECT_EQ(refusal("byteStride", 0, data), "its elements are of a size that cannot be");
  EXPECT_EQ(refusal("mode", "TRIANGLES", data), "its indices are of a size that cannot be");
  EXPECT_EQ(refusal("mode", "OTHERS", data), "its mode is not known");
  EXPECT_EQ(refusal("filter", "OTHER", data), "its filter is not known");
}

/// Every byte of small packed files changed in turn: taken or refused, nothing else.
TEST(GltfMeshopt, EveryChangedByteIsTakenOrRefused) {
  const Grid grid;
  const Packed packed = meshoptBytes(grid, false);
  const std::string data = packed.vertices + packed.triangles;
  const json document = meshoptDocument(grid, packed, false);
  std::size_t refused = 0, tried = 0;
  for (std::size_t at = 0; at < data.size(); at += 7, ++tried) {
    std::string changed = data;
    changed[at] = static_cast<char>(changed[at] ^ (1 + at % 255));
    const std::string file = glbFile(document, changed);
    try {
      readGltf({file, "a.glb"});
    } catch (const ReadError&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 0u);
  EXPECT_LT(refused, tried);
}

}  // namespace
}  // namespace chartflood::test
