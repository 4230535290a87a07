#include "core/io/mesh_formats.h"

#include <algorithm>
#include <array>

#include "core/base/text.h"
#include "core/io/read/read_3mf.h"
#include "core/io/read/read_gltf.h"
#include "core/io/read/read_obj.h"
#include "core/io/read/read_off.h"
#include "core/io/read/read_ply.h"
#include "core/io/read/read_stl.h"

namespace chartflood {

namespace {

constexpr std::string_view kFileBlanks = " \t\r\n";

/// Without the mark that some editors put before text.
std::string_view markless(const Source& source) {
  return source.bytes.substr(static_cast<std::size_t>(source.text() - source.begin()));
}

/// From the first word on.
std::string_view wordsOf(const Source& source) {
  const std::string_view bytes = markless(source);
  return bytes.substr(std::min(bytes.find_first_not_of(kFileBlanks), bytes.size()));
}

/// Whether the first line that says anything begins like a line of OBJ.
bool looksLikeObj(std::string_view bytes) {
  constexpr std::array<std::string_view, 9> kWords = {"v", "vt", "vn",     "f",     "o",
                                                      "g", "s",  "mtllib", "usemtl"};
  for (std::size_t at = bytes.find_first_not_of(kFileBlanks); at < bytes.size();
       at = bytes.find_first_not_of(kFileBlanks, at)) {
    if (bytes[at] == '#') {
      at = std::min(bytes.find_first_of("\r\n", at), bytes.size());
      continue;
    }
    const std::string_view word = bytes.substr(at, 16).substr(
        0, std::min(bytes.find_first_of(kFileBlanks, at), bytes.size()) - at);
    return std::find(kWords.begin(), kWords.end(), word) != kWords.end();
  }
  return false;
}

/// OBJ begins like much other text.
FormatFit fitsObj(const Source& source) {
  return looksLikeObj(markless(source)) ? FormatFit::Loose : FormatFit::No;
}

FormatFit fitsPly(const Source& source) {
  const std::string_view bytes = markless(source);
  return bytes.starts_with("ply\n") || bytes.starts_with("ply\r") ? FormatFit::Certain
                                                                  : FormatFit::No;
}

FormatFit fitsOff(const Source& source) {
  return looksLikeOff(markless(source)) ? FormatFit::Certain : FormatFit::No;
}

FormatFit fitsStl(const Source& source) {
  const std::string_view text = wordsOf(source);
  const bool words = text.starts_with("solid") && text.find("facet") != std::string_view::npos;
  return words || looksLikeBinaryStl(source.bytes) ? FormatFit::Likely : FormatFit::No;
}

FormatFit fitsGltf(const Source& source) {
  const std::string_view text = wordsOf(source);
  return text.starts_with("{") && text.find("\"asset\"") != std::string_view::npos
             ? FormatFit::Likely
             : FormatFit::No;
}

FormatFit fitsGlb(const Source& source) {
  return markless(source).starts_with("glTF") ? FormatFit::Certain : FormatFit::No;
}

std::string writeObj(const ChartedMesh& charted, const MeshWriteOptions& options) {
  return objText(charted, options.obj);
}
std::string writePly(const ChartedMesh& charted, const MeshWriteOptions& options) {
  return plyBytes(charted, options.ply);
}
std::string writeGlb(const ChartedMesh& charted, const MeshWriteOptions& options) {
  return glbBytes(charted, options.glb);
}

constexpr std::array<MeshFormat, 20> kFormats = {{
    {"obj", "Wavefront OBJ", readObj, fitsObj, writeObj,
     "Vertices and faces of the file as they are, polygons included; texture coordinates, charts "
     "as "
     "groups."},
    {"ply", "Stanford PLY", readPly, fitsPly, writePly,
     "Chart and texture coordinates of each face; vertices repeated at seams behind the file's "
     "own."},
    {"off", "Object File Format", readOff, fitsOff},
    {"stl", "Stereolithography", readStl, fitsStl},
    {"gltf", "glTF", readGltf, fitsGltf},
    {"glb", "glTF binary", readGltf, fitsGlb, writeGlb,
     "For engines: vertices split at seams, texture coordinates, the chart of each vertex."},
    {"3mf", "3D Manufacturing Format", read3mf},
    {"fbx", "Autodesk FBX"},
    {"dae", "Collada"},
    {"3ds", "3D Studio"},
    {"blend", "Blender"},
    {"x3d", "X3D"},
    {"amf", "Additive Manufacturing"},
    {"lwo", "LightWave"},
    {"x", "DirectX"},
    {"ac", "AC3D"},
    {"ase", "3ds Max ASCII"},
    {"dxf", "AutoCAD DXF"},
    {"ms3d", "MilkShape 3D"},
    {"b3d", "Blitz3D"},
}};

}  // namespace

std::span<const MeshFormat> meshFormats() { return kFormats; }

const MeshFormat* findMeshFormat(std::string_view extension) {
  if (extension.starts_with('.')) extension.remove_prefix(1);
  const auto same = [&](const MeshFormat& format) {
    return lowerCase(extension) == format.extension;
  };
  const auto found = std::find_if(kFormats.begin(), kFormats.end(), same);
  return found == kFormats.end() ? nullptr : &*found;
}

const MeshFormat* formatOfContent(const Source& source) {
  const MeshFormat* best = nullptr;
  FormatFit bestFit = FormatFit::No;
  for (const MeshFormat& format : kFormats) {
    if (format.fit == nullptr) continue;
    if (const FormatFit fit = format.fit(source); fit > bestFit) best = &format, bestFit = fit;
  }
  return best;
}

std::string extensionList(FormatReader reader) {
  std::string text;
  for (const MeshFormat& format : kFormats) {
    if (format.reader() != reader) continue;
    if (!text.empty()) text += ", ";
    text.append(".").append(format.extension);
  }
  return text;
}

std::vector<std::string> writtenExtensions() {
  std::vector<std::string> written;
  for (const MeshFormat& format : kFormats) {
    if (format.write != nullptr) written.push_back(std::string(".") + format.extension);
  }
  return written;
}

std::string formatTable() {
  std::string text = "| Format | Ends in | Read |\n|---|---|---|\n";
  for (const MeshFormat& format : kFormats) {
    const bool own = format.reader() == FormatReader::Own;
    text.append("| ").append(format.title).append(" | `.").append(format.extension);
    text.append(own ? "` | well |\n" : "` | tried, through the import library |\n");
  }
  return text;
}

}  // namespace chartflood
