#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "io_support.h"

namespace chartflood::test {
namespace {

using nlohmann::json;
using Faces = std::vector<std::vector<Index>>;

/// A GLB file: four corners of a square (12 bytes each), then numbers 0 1 2 3 as 16 bits.
std::string glb(json document) {
  std::string data;
  for (const float x : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 1.f, 1.f, 0.f, 0.f, 1.f, 0.f}) {
    data += bytesOf(x);
  }
  for (std::uint16_t i = 0; i < 4; ++i) data += bytesOf(i);
  document["asset"]["version"] = "2.0";
  document["buffers"] = {{{"byteLength", data.size()}}};
  std::string text = document.dump();
  text.resize((text.size() + 3) / 4 * 4, ' ');
  const auto total = static_cast<std::uint32_t>(12 + 8 + text.size() + 8 + data.size());
  return "glTF" + bytesOf(std::uint32_t{2}) + bytesOf(total) +
         bytesOf(static_cast<std::uint32_t>(text.size())) + "JSON" + text +
         bytesOf(static_cast<std::uint32_t>(data.size())) + std::string("BIN\0", 4) + data;
}

/// The square as a fan of two triangles.
json square() {
  return {{"bufferViews",
           {{{"buffer", 0}, {"byteOffset", 0}, {"byteLength", 48}},
            {{"buffer", 0}, {"byteOffset", 48}, {"byteLength", 8}}}},
          {"accessors",
           {{{"bufferView", 0}, {"componentType", 5126}, {"count", 4}, {"type", "VEC3"}},
            {{"bufferView", 1}, {"componentType", 5123}, {"count", 4}, {"type", "SCALAR"}}}},
          {"meshes",
           {{{"primitives", {{{"attributes", {{"POSITION", 0}}}, {"indices", 1}, {"mode", 6}}}}}}},
          {"nodes", {{{"mesh", 0}}}},
          {"scenes", {{{"nodes", {0}}}}},
          {"scene", 0}};
}

TEST(ReadGltf, TakesFansStripsAndLists) {
  json document = square();
  EXPECT_EQ(facesOf(*readBytes("a.glb", glb(document))), (Faces{{0, 1, 2}, {0, 2, 3}}));
  document["meshes"][0]["primitives"][0]["mode"] = 5;
  EXPECT_EQ(facesOf(*readBytes("a.glb", glb(document))), (Faces{{0, 1, 2}, {2, 1, 3}}));
  document["meshes"][0]["primitives"][0].erase("mode");
  document["accessors"][1]["count"] = 3;
  EXPECT_EQ(facesOf(*readBytes("a.glb", glb(document))), (Faces{{0, 1, 2}}));
  document["meshes"][0]["primitives"][0].erase("indices");
  document["accessors"][0]["count"] = 3;
  EXPECT_EQ(facesOf(*readBytes("a.glb", glb(document))), (Faces{{0, 1, 2}}));
}

TEST(ReadGltf, AppliesTheTransformsOfAllNodesAbove) {
  json document = square();
  document["nodes"] = {{{"children", {1}}, {"translation", {10, 0, 0}}},
                       {{"mesh", 0}, {"scale", {2, 3, 1}}}};
  const auto mesh = readBytes("a.glb", glb(document));
  EXPECT_EQ(mesh->positions[2], glm::dvec3(12, 3, 0));
  document["nodes"][1] = {{"mesh", 0},
                          {"matrix", {0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 5, 6, 7, 1}}};
  EXPECT_EQ(readBytes("a.glb", glb(document))->positions[1], glm::dvec3(15, 7, 7));
}

TEST(ReadGltf, TurnsFacesOfMirroredNodes) {
  json document = square();
  document["nodes"][0]["scale"] = {-1, 1, 1};
  EXPECT_EQ(facesOf(*readBytes("a.glb", glb(document))), (Faces{{0, 2, 1}, {0, 3, 2}}));
}

TEST(ReadGltf, RepeatsMeshesOfSeveralNodesAndBuildingJoinsWhatCoincides) {
  json document = square();
  document["nodes"] = {{{"mesh", 0}}, {{"mesh", 0}, {"translation", {1, 0, 0}}}};
  document["scenes"][0]["nodes"] = {0, 1};
  const auto mesh = readBytes("a.glb", glb(document));
  EXPECT_EQ(facesOf(*mesh), (Faces{{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}}));
  const auto built = buildBytes("a.glb", glb(document));
  EXPECT_EQ(built->componentCount(), 1u);
  EXPECT_EQ(countOf(built->repairs(), "welded-vertices"), 2u);
  EXPECT_EQ(built->standIn(4), 1u);
  EXPECT_EQ(built->standIn(7), 2u);
}

TEST(ReadGltf, AppliesSparseEntries) {
  json document = square();
  document["accessors"][0]["sparse"] = {
      {"count", 1},
      {"indices", {{"bufferView", 1}, {"byteOffset", 4}, {"componentType", 5123}}},
      {"values", {{"bufferView", 0}, {"byteOffset", 12}}}};
  EXPECT_EQ(readBytes("a.glb", glb(document))->positions[2], glm::dvec3(1, 0, 0));
  document["accessors"][0]["sparse"]["count"] = 9;
  EXPECT_EQ(refusalOf("a.glb", glb(document)), "its accessor 0 is longer than its buffer view");
}

TEST(ReadGltf, StepsOverInterleavedData) {
  json document = square();
  document["bufferViews"][0]["byteStride"] = 24;
  document["accessors"][0]["count"] = 2;
  document["accessors"][1]["count"] = 2;
  EXPECT_EQ(refusalOf("a.glb", glb(document)), "none of its nodes shows triangles");
  document["accessors"][0]["count"] = 3;
  EXPECT_EQ(refusalOf("a.glb", glb(document)), "its accessor 0 is longer than its buffer view");
  document["bufferViews"][0]["byteStride"] = 12;
  document["accessors"][1]["count"] = 3;
  EXPECT_EQ(readBytes("a.glb", glb(document))->positions[2], glm::dvec3(1, 1, 0));
}

TEST(ReadGltf, RefusesWhatLiesOutsideOfTheFile) {
  const auto refusal = [](const char* pointer, const json& value) {
    json document = square();
    document[json::json_pointer(pointer)] = value;
    return refusalOf("a.glb", glb(document));
  };
  EXPECT_EQ(refusal("/accessors/0/count", 5), "its accessor 0 is longer than its buffer view");
  EXPECT_EQ(refusal("/accessors/0/count", 4000000000u),
            "its accessor 0 is longer than its buffer view");
  EXPECT_EQ(refusal("/accessors/0/byteOffset", 4), "its accessor 0 is longer than its buffer view");
  EXPECT_EQ(refusal("/bufferViews/0/byteLength", 1000),
            "its accessor 0 lies in a buffer view that is longer than its buffer");
  EXPECT_EQ(refusal("/accessors/0/bufferView", 7),
            "its accessor 0 names a buffer view that does not exist");
  EXPECT_EQ(refusal("/meshes/0/primitives/0/indices", 7), "it names accessor 7 but there are 2");
  EXPECT_EQ(refusal("/nodes/0/mesh", 3), "it names mesh 3 but there are 1");
  EXPECT_EQ(refusal("/scenes/0/nodes", {4}), "it names node 4 but there are 1");
  EXPECT_EQ(refusal("/nodes/0/children", {0}), "its node 0 hangs below two nodes or below itself");
  EXPECT_EQ(refusal("/accessors/0/count", 3),
            "a face names vertex 3 but there are 3 (counted from 0)");
  EXPECT_EQ(refusal("/accessors/1/componentType", 5122),
            "its accessor 1 gives vertex numbers that are not unsigned whole numbers");
}

TEST(ReadGltf, RefusesDeepNestingBeforeParsing) {
  std::string text = R"({"asset":{"version":"2.0"},"extras":)";
  text += std::string(100000, '[') + std::string(100000, ']') + "}";
  EXPECT_NE(refusalOf("a.gltf", text).find("the JSON is nested too deeply"), std::string::npos);
}

TEST(ReadGltf, ReadsBuffersBesideTheFileOnly) {
  json document = square();
  document["asset"]["version"] = "2.0";
  document["buffers"] = {{{"byteLength", 56}, {"uri", "square%20data.bin"}}};
  EXPECT_EQ(refusalOf("a.gltf", document.dump()),
            "its buffer square data.bin is not in the file's folder");
  const TemporaryFolder folder;
  const std::string whole = glb(square());
  folder.write("square data.bin", whole.substr(whole.size() - 56));
  const auto mesh = readBytes("a.glb", whole);
  folder.write("a.gltf", document.dump());
  EXPECT_EQ(facesOf(*readFile(folder.path() / "a.gltf")), facesOf(*mesh));
}

}  // namespace
}  // namespace chartflood::test
