#include "tests/support/mutation_seeds.h"

#include <cstdint>
#include <stdexcept>
#include <utility>
#include <vector>

#include <assimp/Exporter.hpp>
#include <assimp/Importer.hpp>
#include <assimp/scene.h>

namespace chartflood::test {

namespace {

/// Two boxes of quads beside each other, with texture coordinates and normals.
std::string boxes() {
  std::string text = "o boxes\n";
  for (int box = 0; box < 2; ++box) {
    for (int corner = 0; corner < 8; ++corner) {
      text += "v " + std::to_string(3 * box + (corner & 1)) + " " +
              std::to_string((corner >> 1) & 1) + " " + std::to_string(corner >> 2) + "\n";
    }
  }
  text += "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvn 0 0 1\n";
  constexpr int kFaces[6][4] = {{1, 3, 4, 2}, {5, 6, 8, 7}, {1, 2, 6, 5},
                                {3, 7, 8, 4}, {1, 5, 7, 3}, {2, 4, 8, 6}};
  for (int box = 0; box < 2; ++box) {
    for (const auto& face : kFaces) {
      text += "f";
      for (int i = 0; i < 4; ++i) {
        text += " " + std::to_string(face[i] + 8 * box) + "/" + std::to_string(i + 1) + "/1";
      }
      text += "\n";
    }
  }
  return text;
}

std::string exported(const aiScene& scene, const char* format) {
  Assimp::Exporter exporter;
  const aiExportDataBlob* const blob = exporter.ExportToBlob(&scene, format);
  if (blob == nullptr) throw std::runtime_error(exporter.GetErrorString());
  return {static_cast<const char*>(blob->data), blob->size};
}

/// A figure with a bone and an animation, which no exporter writes.
std::string skinnedX() {
  const std::string identity = "1.0,0.0,0.0,0.0,0.0,1.0,0.0,0.0,0.0,0.0,1.0,0.0,0.0,0.0,0.0,1.0;;";
  return "xof 0303txt 0032\nFrame Root {\n FrameTransformMatrix { " + identity +
         " }\n Frame Bone { FrameTransformMatrix { " + identity +
         " } }\n Mesh Body {\n  4;\n  0.0;0.0;0.0;,\n  1.0;0.0;0.0;,\n  0.0;1.0;0.0;,\n"
         "  0.0;0.0;1.0;;\n  4;\n  3;0,2,1;,\n  3;0,1,3;,\n  3;1,2,3;,\n  3;2,0,3;;\n"
         "  MeshTextureCoords { 4; 0.0;0.0;, 1.0;0.0;, 0.0;1.0;, 1.0;1.0;; }\n"
         "  MeshMaterialList { 1; 4; 0, 0, 0, 0; Material Red { 1.0;0.0;0.0;1.0;; 1.0; "
         "1.0;1.0;1.0;; 0.0;0.0;0.0;; TextureFilename { \"red.png\"; } } }\n"
         "  XSkinMeshHeader { 1; 1; 1; }\n  SkinWeights {\n   \"Bone\";\n   4;\n   0, 1, 2, 3;\n"
         "   1.0, 1.0, 0.5, 0.5;\n   " +
         identity +
         "\n  }\n }\n}\nAnimationSet Walk { Animation { { Bone } AnimationKey { 4; 2; 0; 16; " +
         identity + ", 1; 16; " + identity + "; } } }\n";
}

template <class T>
std::string bytesOf(T value) {
  return {reinterpret_cast<const char*>(&value), sizeof value};
}

/// A record of binary FBX. The library cannot read the binary FBX that it writes itself.
struct FbxRecord {
  std::string name;
  std::vector<std::string> values;  ///< each with the letter of its type
  std::vector<FbxRecord> inside;

  /// The bytes at a place of the file: records tell where they end.
  std::string bytes(std::size_t at) const {
    std::string all;
    for (const std::string& value : values) all += value;
    const std::size_t valueBytes = all.size();
    const std::size_t head = 13 + name.size();
    for (const FbxRecord& record : inside) all += record.bytes(at + head + all.size());
    if (!inside.empty()) all += std::string(13, '\0');
    return bytesOf(static_cast<std::uint32_t>(at + head + all.size())) +
           bytesOf(static_cast<std::uint32_t>(values.size())) +
           bytesOf(static_cast<std::uint32_t>(valueBytes)) + static_cast<char>(name.size()) + name +
           all;
  }
};

std::string fbxText(const std::string& text) {
  return "S" + bytesOf(static_cast<std::uint32_t>(text.size())) + text;
}
std::string fbxNumber(std::int64_t number) { return "L" + bytesOf(number); }

template <class T>
std::string fbxArray(char type, const std::vector<T>& numbers) {
  std::string bytes = type + bytesOf(static_cast<std::uint32_t>(numbers.size())) +
                      bytesOf(std::uint32_t{0}) +
                      bytesOf(static_cast<std::uint32_t>(numbers.size() * sizeof(T)));
  for (const T number : numbers) bytes += bytesOf(number);
  return bytes;
}

/// A tetrahedron and a quad; the last corner of a face is written as its complement.
std::string binaryFbx() {
  using std::string_literals::operator""s;
  const FbxRecord geometry{
      "Geometry",
      {fbxNumber(10), fbxText("Body\0\x01Geometry"s), fbxText("Mesh")},
      {{"Vertices", {fbxArray<double>('d', {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 0})}, {}},
       {"PolygonVertexIndex",
        {fbxArray<std::int32_t>('i', {0, 2, ~1, 0, 1, ~3, 1, 2, ~3, 2, 0, ~3, 0, 1, 4, ~2})},
        {}}}};
  const FbxRecord model{"Model",
                        {fbxNumber(20), fbxText("Body\0\x01Model"s), fbxText("Mesh")},
                        {{"Version", {"I" + bytesOf(std::int32_t{232})}, {}}}};
  const std::vector<FbxRecord> records = {
      {"FBXHeaderExtension", {}, {{"FBXVersion", {"I" + bytesOf(std::int32_t{7400})}, {}}}},
      {"Objects", {}, {geometry, model}},
      {"Connections",
       {},
       {{"C", {fbxText("OO"), fbxNumber(20), fbxNumber(0)}, {}},
        {"C", {fbxText("OO"), fbxNumber(10), fbxNumber(20)}, {}}}}};
  std::string file = "Kaydara FBX Binary  \0\x1a\0"s + bytesOf(std::uint32_t{7400});
  for (const FbxRecord& record : records) file += record.bytes(file.size());
  return file + std::string(13, '\0');
}

SeedFile seed3mf() {
  const std::string identity = "1 0 0 0 1 0 0 0 1 ";
  const std::string other =
      model3mf("<object id=\"1\" type=\"model\">" + cubeMesh3mf() + "</object><object id=\"3\">" +
                   cubeMesh3mf(2) + "</object>",
               "", "unit=\"millimeter\"");
  const std::string main = model3mf(
      "<basematerials id=\"9\"><base name=\"red\" displaycolor=\"#ff0000\"/></basematerials>"
      "<object id=\"2\" pid=\"9\" pindex=\"0\"><components>"
      "<component objectid=\"1\" p:path=\"/3D/one.model\" transform=\"" +
          identity +
          "5 5 0\"/>"
          "<component objectid=\"3\" p:path=\"/3D/one.model\"/></components></object>",
      "<item objectid=\"2\" transform=\"0 1 0 -1 0 0 0 0 1 0 0 0\"/><item objectid=\"2\"/>",
      "unit=\"millimeter\" requiredextensions=\"p\"");
  return {"3mf",
          "3mf",
          "",
          {{"[Content_Types].xml", "<Types xmlns=\"http://schemas.openxmlformats.org/package/2006/"
                                   "content-types\"/>"},
           {"_rels/.rels",
            "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">"
            "<Relationship Target=\"/3D/main.model\" Id=\"r0\" "
            "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/>"
            "</Relationships>"},
           {"3D/main.model", main},
           {"3D/one.model", other},
           {"Metadata/thumbnail.png", "\x89PNG\r\n\x1a\n no real picture"}}};
}

}  // namespace

std::vector<SeedFile> mutationSeeds() {
  const std::string obj = boxes();
  Assimp::Importer importer;
  const aiScene* const scene = importer.ReadFileFromMemory(obj.data(), obj.size(), 0, "obj");
  if (scene == nullptr) throw std::runtime_error(importer.GetErrorString());
  return {seed3mf(),
          {"skinned x", "x", skinnedX(), {}},
          {"x", "x", exported(*scene, "x"), {}},
          {"binary fbx", "fbx", binaryFbx(), {}},
          {"fbx as text", "fbx", exported(*scene, "fbxa"), {}},
          {"collada", "dae", exported(*scene, "collada"), {}},
          {"3ds", "3ds", exported(*scene, "3ds"), {}},
          {"x3d", "x3d", exported(*scene, "x3d"), {}}};
}

}  // namespace chartflood::test
