// glTF files as exporters and strangers write them: extensions, versions, names of buffers, what
// lies outside of the folder, and what is left out.

#include <sys/stat.h>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/io/read/data_uri.h"
#include "gltf_support.h"

namespace chartflood::test {
namespace {

using nlohmann::json;

const std::filesystem::path kCases = CHARTFLOOD_CASES;

std::string caseRefusal(const char* file) {
  try {
    readFile(kCases / file);
  } catch (const ReadError& error) {
    return error.cause();
  }
  return "";
}

/// A tetrahedron in one buffer: 48 bytes of places, then 12 corners of 16 bits.
std::string tetrahedronBytes() {
  std::string data;
  for (const float x : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f}) {
    data += bytesOf(x);
  }
  for (const int v : {0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2}) {
    data += bytesOf(static_cast<std::uint16_t>(v));
  }
  return data;
}

json tetrahedron() {
  return {{"bufferViews",
           {{{"buffer", 0}, {"byteLength", 48}},
            {{"buffer", 0}, {"byteOffset", 48}, {"byteLength", 24}}}},
          {"accessors",
           {{{"bufferView", 0}, {"componentType", 5126}, {"count", 4}, {"type", "VEC3"}},
            {{"bufferView", 1}, {"componentType", 5123}, {"count", 12}, {"type", "SCALAR"}}}},
          {"buffers", {{{"byteLength", 72}}}},
          {"meshes", {{{"primitives", {{{"attributes", {{"POSITION", 0}}}, {"indices", 1}}}}}}},
          {"nodes", {{{"mesh", 0}}}},
          {"scenes", {{{"nodes", {0}}}}},
          {"scene", 0}};
}

std::string glbOf(const json& document) { return glbFile(document, tetrahedronBytes()); }

TEST(GltfCases, CompressedDataThatAreNoneNameTheExtension) {
  EXPECT_EQ(caseRefusal("draco-no-buffer-view.gltf"),
            "its geometry is compressed (KHR_draco_mesh_compression) and cannot be unpacked: its "
            "data are broken or cut off");
  EXPECT_EQ(caseRefusal("meshopt-fallback-buffer.glb"),
            "its buffer view 0 is compressed (EXT_meshopt_compression) and cannot be unpacked: it "
            "is not of the format that the extension has");
}

TEST(GltfCases, MaterialsNeverRefuseAFile) {
  EXPECT_EQ(readFile(kCases / "required-extension-of-materials.gltf")->faceCount(), 12u);
  for (const char* extension :
       {"KHR_materials_unlit", "KHR_texture_basisu", "KHR_xmp_json_ld", "KHR_node_visibility",
        "VRM", "VRMC_vrm", "CESIUM_RTC", "KHR_mesh_quantization", "ACME_of_nobody"}) {
    json document = tetrahedron();
    document["extensionsRequired"] = {extension};
    document["extensions"][extension] = json::object();
    EXPECT_EQ(readBytes("a.glb", glbOf(document))->faceCount(), 4u) << extension;
  }
}

TEST(GltfCases, UnknownExtensionsOfTheGeometryRefuseItBeforeAnythingElseFails) {
  json document = tetrahedron();
  document["extensionsRequired"] = {"ACME_packed"};
  document["meshes"][0]["primitives"][0]["extensions"]["ACME_packed"] = json::object();
  document["accessors"][0]["count"] = "many";
  EXPECT_EQ(refusalOf("a.glb", glbOf(document)),
            "it needs the glTF extension \"ACME_packed\", which changes the geometry in a way that "
            "is not known here; save it without that extension");
}

TEST(GltfCases, InstancesAreRead) {
  const auto mesh = readFile(kCases / "instancing-not-required.gltf");
  EXPECT_EQ(mesh->faceCount(), 36u);
  EXPECT_EQ(mesh->positions[8], glm::dvec3(3, 0, 0));
  EXPECT_EQ(mesh->positions[16], glm::dvec3(6, 0, 0));
}

TEST(GltfCases, InstancesAreTurnedAndScaled) {
  json document = tetrahedron();
  std::string data = tetrahedronBytes();
  // A quarter turn about z, and as large as -2: mirrored.
  for (const float x : {0.f, 0.f, 0.70710678f, 0.70710678f}) data += bytesOf(x);
  for (const float x : {-2.f, 2.f, 2.f}) data += bytesOf(x);
  document["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", 72}, {"byteLength", 16}});
  document["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", 88}, {"byteLength", 12}});
  document["accessors"].push_back(
      {{"bufferView", 2}, {"componentType", 5126}, {"count", 1}, {"type", "VEC4"}});
  document["accessors"].push_back(
      {{"bufferView", 3}, {"componentType", 5126}, {"count", 1}, {"type", "VEC3"}});
  document["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = {{"ROTATION", 2},
                                                                                 {"SCALE", 3}};
  const auto mesh = readBytes("a.glb", glbFile(document, data));
  EXPECT_NEAR(glm::length(mesh->positions[1] - glm::dvec3(0, -2, 0)), 0, 1e-6);
  EXPECT_NEAR(glm::length(mesh->positions[2] - glm::dvec3(-2, 0, 0)), 0, 1e-6);
  EXPECT_EQ(facesOf(*mesh)[0], (std::vector<Index>{0, 1, 2}));
}

TEST(GltfCases, FewBytesCannotAskForAnyNumberOfTriangles) {
  json document = tetrahedron();
  const std::size_t count = 30'000'000;
  document["accessors"].push_back({{"componentType", 5120},
                                   {"count", count},
                                   {"type", "VEC3"},
                                   {"sparse",
                                    {{"count", 0},
                                     {"indices", {{"bufferView", 1}, {"componentType", 5123}}},
                                     {"values", {{"bufferView", 0}}}}}});
  document["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]["TRANSLATION"] = 2;
  EXPECT_EQ(refusalOf("a.glb", glbOf(document)),
            "its accessor 2 counts more elements than the file can hold");
}

TEST(GltfCases, RepeatingAMeshHasALimit) {
  json document = tetrahedron();
  // 40 thousand corners, 40 thousand times.
  constexpr std::size_t kCorners = 39'999, kInstances = 40'000;
  std::string data = tetrahedronBytes() + std::string(3 * kInstances, '\0');
  document["accessors"][0] = {
      {"bufferView", 2}, {"componentType", 5121}, {"count", kCorners}, {"type", "VEC3"}};
  document["meshes"][0]["primitives"][0].erase("indices");
  document["bufferViews"].push_back(
      {{"buffer", 0}, {"byteOffset", 72}, {"byteLength", 3 * kInstances}});
  document["accessors"].push_back(
      {{"bufferView", 2}, {"componentType", 5121}, {"count", kInstances}, {"type", "VEC3"}});
  document["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]["SCALE"] = 2;
  EXPECT_EQ(refusalOf("a.glb", glbFile(document, data)),
            "repeating its meshes comes to more than 200000000 vertices and corners; save fewer "
            "instances");
}

TEST(GltfCases, MorphsAndPosesThatAreLeftOutAreSaid) {
  json document = tetrahedron();
  document["meshes"][0]["primitives"][0]["targets"] = {{{"POSITION", 0}}};
  EXPECT_TRUE(readBytes("a.glb", glbOf(document))->repairs.empty());
  document["meshes"][0]["weights"] = {0.5};
  EXPECT_EQ(countOf(readBytes("a.glb", glbOf(document))->repairs, "morphs-ignored"), 1u);
  document["nodes"][0]["weights"] = {0};
  EXPECT_TRUE(readBytes("a.glb", glbOf(document))->repairs.empty());
  document["skins"] = {{{"joints", {0}}}};
  document["nodes"][0]["skin"] = 0;
  EXPECT_EQ(countOf(readBytes("a.glb", glbOf(document))->repairs, "poses-ignored"), 1u);
}

TEST(GltfCases, QuantizedPlacesAreNumbersOfTheirOwn) {
  json document = tetrahedron();
  std::string data;
  for (const int x : {0, 0, 0, 0, 32767, 0, 0, 0, 0, 16384, 0, 0, 0, 0, -32768, 0}) {
    data += bytesOf(static_cast<std::int16_t>(x));
  }
  for (const int v : {0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2}) {
    data += bytesOf(static_cast<std::uint8_t>(v));
  }
  document["extensionsRequired"] = {"KHR_mesh_quantization"};
  document["bufferViews"] = {{{"buffer", 0}, {"byteLength", 32}, {"byteStride", 8}},
                             {{"buffer", 0}, {"byteOffset", 32}, {"byteLength", 12}}};
  document["accessors"][0]["componentType"] = 5122;
  document["accessors"][1]["componentType"] = 5121;
  EXPECT_EQ(readBytes("a.glb", glbFile(document, data))->positions[2], glm::dvec3(0, 16384, 0));
  document["accessors"][0]["normalized"] = true;
  const auto mesh = readBytes("a.glb", glbFile(document, data));
  EXPECT_EQ(mesh->positions[1], glm::dvec3(1, 0, 0));
  EXPECT_EQ(mesh->positions[3], glm::dvec3(0, 0, -1));
}

TEST(GltfCases, TheFirstVersionIsReadByTheImportLibrary) {
  const auto mesh = readFile(kCases / "gltf-1.0.gltf");
  EXPECT_EQ(mesh->faceCount(), 12u);
  EXPECT_EQ(mesh->positions.size(), 8u);
}

TEST(GltfCases, OtherVersionsAreNamed) {
  const auto refusal = [](const char* version) {
    json document = tetrahedron();
    document["asset"]["version"] = version;
    return refusalOf("a.gltf", document.dump());
  };
  EXPECT_EQ(refusal("3.0"), "it is glTF \"3.0\"; versions 1 and 2 are read");
  EXPECT_EQ(refusal("1.0").substr(0, 19), "it is glTF 1.0, and");
  std::string binary = glbOf(tetrahedron());
  binary[4] = 7;
  EXPECT_EQ(refusalOf("a.glb", binary), "it is GLB 7; versions 1 and 2 are read");
}

// Names and places of buffers

TEST(GltfBuffers, NamesStandAsTheyAreWhereAnEscapeIsNone) {
  EXPECT_EQ(readFile(kCases / "buffer-name-with-percent.gltf")->faceCount(), 12u);
  EXPECT_EQ(withoutEscapes("ten%2010%.bin"), "ten 10%.bin");
  EXPECT_EQ(withoutEscapes("100%zz%2"), "100%zz%2");
}

/// A folder with models and, beside it, a buffer that none of them may read.
class GltfBufferPlaces : public ::testing::Test {
 protected:
  void SetUp() override {
    std::filesystem::create_directories(all_.path() / "models/parts");
    std::filesystem::create_directories(all_.path() / "outside");
    for (const char* file : {"outside/secret.bin", "models/parts/a.bin", "models/a%20b.bin"}) {
      all_.write(file, tetrahedronBytes());
    }
  }
  std::string refusal(const std::string& uri) const {
    json document = tetrahedron();
    document["asset"]["version"] = "2.0";
    document["buffers"][0]["uri"] = uri;
    const auto file = all_.write("models/a.gltf", document.dump());
    try {
      EXPECT_EQ(readFile(file)->faceCount(), 4u);
    } catch (const ReadError& error) {
      return error.cause();
    }
    return "";
  }
  TemporaryFolder all_;
};

TEST_F(GltfBufferPlaces, LieInTheFolderOrBelow) {
  EXPECT_EQ(refusal("parts/a.bin"), "");
  EXPECT_EQ(refusal("parts/%61.bin"), "");
  // The escape is none of the exporter's: the name is the file's.
  EXPECT_EQ(refusal("a%20b.bin"), "");
}

TEST_F(GltfBufferPlaces, OutsideAreRefused) {
  const std::string where = " lies outside of the file's folder; put it beside the file or below";
  EXPECT_EQ(caseRefusal("buffer-outside-the-folder.gltf"),
            "its buffer ../outside/secret.bin" + where);
  const std::string secret = (all_.path() / "outside/secret.bin").string();
  for (const std::string& uri :
       {std::string("../outside/secret.bin"), std::string("..%2foutside/secret.bin"),
        std::string("%2e%2e/outside/secret.bin"), secret}) {
    EXPECT_EQ(refusal(uri), "its buffer " + shownName(withoutEscapes(uri)) + where);
  }
  std::filesystem::create_symlink("../outside/secret.bin", all_.path() / "models/link.bin");
  EXPECT_EQ(refusal("link.bin"), "its buffer link.bin" + where);
}

TEST_F(GltfBufferPlaces, PipesAndDevicesAreNotOpened) {
  ASSERT_EQ(::mkfifo((all_.path() / "models/pipe.bin").c_str(), 0600), 0);
  EXPECT_EQ(refusal("pipe.bin"), "its buffer pipe.bin is a pipe; only files can be read");
  std::filesystem::create_symlink("/dev/zero", all_.path() / "models/zero.bin");
  EXPECT_NE(refusal("zero.bin"), "");
  EXPECT_EQ(refusal("none.bin"), "its buffer none.bin is not in the file's folder");
}

TEST_F(GltfBufferPlaces, NoSentenceRepeatsDataThatAreWrittenIntoTheFile) {
  const std::string broken = "data:application/octet-stream;base64," + std::string(500'000, '*');
  EXPECT_EQ(refusal(broken),
            "its buffer 0 is written into the file as text that is no whole base64");
  for (const std::string& uri :
       {std::string(500'000, 'x'), "parts/" + std::string(200, 'y'), std::string(500'000, '%')}) {
    EXPECT_NE(refusal(uri), "");
    EXPECT_LE(refusal(uri).size(), 300u);
  }
  json document = tetrahedron();
  document["asset"]["version"] = std::string(500'000, '2') + broken;
  document["buffers"][0]["uri"] = broken;
  document["scene"] = broken;
  EXPECT_LE(refusalOf("a.gltf", document.dump()).size(), 300u);
  EXPECT_LE(refusalOf("a.gltf", document.dump() + "}").size(), 300u);
}

TEST(DataUris, AreBase64OrEscapedText) {
  EXPECT_EQ(decodeDataUri("data:;base64,aGFsbG8="), "hallo");
  EXPECT_EQ(decodeDataUri("data:application/gltf-buffer;base64,aGFsbG8"), "hallo");
  EXPECT_EQ(decodeDataUri("data:,a%20b"), "a b");
  EXPECT_EQ(decodeDataUri("data:;base64,aGFsb"), std::nullopt);
  EXPECT_EQ(decodeDataUri("data:;base64,a GFs"), std::nullopt);
  EXPECT_EQ(decodeDataUri("data:;base64"), std::nullopt);
}

}  // namespace
}  // namespace chartflood::test
