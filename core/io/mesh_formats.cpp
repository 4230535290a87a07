#include "core/io/mesh_formats.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace chartflood {

namespace {

constexpr FormatReader kOwn = FormatReader::Own, kLibrary = FormatReader::Library;

constexpr std::array<MeshFormat, 20> kReadable = {{
    {"obj", "Wavefront OBJ", kOwn},
    {"ply", "Stanford PLY", kOwn},
    {"off", "Object File Format", kOwn},
    {"stl", "Stereolithography", kOwn},
    {"gltf", "glTF", kOwn},
    {"glb", "glTF binary", kOwn},
    {"3mf", "3D Manufacturing Format", kOwn},
    {"fbx", "Autodesk FBX", kLibrary},
    {"dae", "Collada", kLibrary},
    {"3ds", "3D Studio", kLibrary},
    {"blend", "Blender", kLibrary},
    {"x3d", "X3D", kLibrary},
    {"amf", "Additive Manufacturing", kLibrary},
    {"lwo", "LightWave", kLibrary},
    {"x", "DirectX", kLibrary},
    {"ac", "AC3D", kLibrary},
    {"ase", "3ds Max ASCII", kLibrary},
    {"dxf", "AutoCAD DXF", kLibrary},
    {"ms3d", "MilkShape 3D", kLibrary},
    {"b3d", "Blitz3D", kLibrary},
}};

}  // namespace

std::span<const MeshFormat> meshFormats() { return kReadable; }

const MeshFormat* findMeshFormat(std::string_view extension) {
  if (extension.starts_with('.')) extension.remove_prefix(1);
  const auto same = [&](const MeshFormat& format) {
    return std::ranges::equal(extension, std::string_view(format.extension), {},
                              [](char c) { return std::tolower(static_cast<unsigned char>(c)); });
  };
  const auto found = std::find_if(kReadable.begin(), kReadable.end(), same);
  return found == kReadable.end() ? nullptr : &*found;
}

std::string extensionList(FormatReader reader) {
  std::string text;
  for (const MeshFormat& format : kReadable) {
    if (format.reader != reader) continue;
    if (!text.empty()) text += ", ";
    text.append(".").append(format.extension);
  }
  return text;
}

std::string formatTable() {
  std::string text = "| Format | Ends in | Read |\n|---|---|---|\n";
  for (const MeshFormat& format : kReadable) {
    const bool own = format.reader == FormatReader::Own;
    text.append("| ").append(format.title).append(" | `.").append(format.extension);
    text.append(own ? "` | well |\n" : "` | tried, through the import library |\n");
  }
  return text;
}

}  // namespace chartflood
