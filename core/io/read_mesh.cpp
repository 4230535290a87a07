#include "core/io/read_mesh.h"

#include <algorithm>
#include <array>
#include <new>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "core/base/error.h"
#include "core/base/file_bytes.h"
#include "core/io/mesh_formats.h"
#include "core/io/read/read_3mf.h"
#include "core/io/read/read_assimp.h"
#include "core/io/read/read_gltf.h"
#include "core/io/read/read_obj.h"
#include "core/io/read/read_off.h"
#include "core/io/read/read_ply.h"
#include "core/io/read/read_stl.h"
#include "core/io/text/source.h"

namespace chartflood {

namespace {

/// Whether the first line that says anything begins like a line of OBJ.
bool looksLikeObj(std::string_view bytes) {
  constexpr std::array<std::string_view, 9> kWords = {"v", "vt", "vn",     "f",     "o",
                                                      "g", "s",  "mtllib", "usemtl"};
  constexpr std::string_view kBlanks = " \t\r\n";
  for (std::size_t at = bytes.find_first_not_of(kBlanks); at < bytes.size();
       at = bytes.find_first_not_of(kBlanks, at)) {
    if (bytes[at] == '#') {
      at = std::min(bytes.find_first_of("\r\n", at), bytes.size());
      continue;
    }
    const std::string_view word = bytes.substr(at, 16).substr(
        0, std::min(bytes.find_first_of(kBlanks, at), bytes.size()) - at);
    return std::find(kWords.begin(), kWords.end(), word) != kWords.end();
  }
  return false;
}

/// The extension that fits the content, "" when none of the formats with own readers does.
std::string_view formatOfContent(const Source& source) {
  const std::string_view bytes =
      source.bytes.substr(static_cast<std::size_t>(source.text() - source.begin()));
  if (bytes.starts_with("ply\n") || bytes.starts_with("ply\r")) return "ply";
  if (bytes.starts_with("glTF")) return "glb";
  if (looksLikeOff(bytes)) return "off";
  if (looksLikeBinaryStl(source.bytes)) return "stl";
  const std::size_t start = std::min(bytes.find_first_not_of(" \t\r\n"), bytes.size());
  const std::string_view text = bytes.substr(start);
  if (text.starts_with("solid") && text.find("facet") != std::string_view::npos) return "stl";
  if (text.starts_with("{") && text.find("\"asset\"") != std::string_view::npos) return "gltf";
  return looksLikeObj(bytes) ? "obj" : "";
}

std::string formatOf(const std::filesystem::path& file, const Source& source) {
  const std::string ending = file.extension().string();
  const MeshFormat* const known = findMeshFormat(ending);
  const std::string_view content = formatOfContent(source);
  if (known == nullptr) {
    if (!content.empty()) return std::string(content);
    source.fail("its format is not known; supported are " + extensionList(FormatReader::Own) +
                ", and tried " + extensionList(FormatReader::Library));
  }
  const std::string_view extension = known->extension;
  // Only formats with an unmistakable beginning: OBJ and STL readers take nearly anything.
  const bool certain = content == "ply" || content == "off" || content == "glb";
  const bool own = known->reader == FormatReader::Own;
  const bool same = content == extension || (content == "glb" && extension == "gltf");
  if (certain && own && !same) {
    source.fail("its content is of the format ." + std::string(content) +
                " although its name ends in ." + std::string(extension) +
                "; rename it to end in ." + std::string(content));
  }
  return std::string(extension);
}

InputMesh readAs(std::string_view format, const Source& source) {
  if (format == "obj") return readObj(source);
  if (format == "ply") return readPly(source);
  if (format == "off") return readOff(source);
  if (format == "stl") return readStl(source);
  if (format == "gltf" || format == "glb") return readGltf(source);
  if (format == "3mf") return read3mf(source);
  return readAssimp(source, format);
}

}  // namespace

std::shared_ptr<const InputMesh> readMesh(const std::filesystem::path& file, Progress* progress) {
  if (progress != nullptr) progress->beginPhase("Reading");
  const std::string name = file.string();
  try {
    const FileBytes bytes(file);
    const Source source{bytes.view(), name, file.parent_path(), progress};
    if (source.bytes.empty()) source.fail("the file is empty");
    InputMesh mesh = readAs(formatOf(file, source), source);
    if (progress != nullptr && progress->cancelled()) return nullptr;
    mesh.file = name;
    if (mesh.positions.size() >= kNone || mesh.corners.size() >= kNone) {
      source.fail("it has more than 4 billion vertices or corners");
    }
    mesh.shrink();
    if (progress != nullptr) progress->setFraction(1);
    return std::make_shared<const InputMesh>(std::move(mesh));
  } catch (const std::bad_alloc&) {
    throw ReadError(name, "it does not fit into memory");
  } catch (const std::length_error&) {
    throw ReadError(name, "it does not fit into memory");
  }
}

}  // namespace chartflood
