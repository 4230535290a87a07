#include "core/io/write_mesh.h"

#include <algorithm>
#include <array>
#include <cctype>

#include "core/base/error.h"
#include "core/io/write/file_output.h"

namespace chartflood {

namespace {

constexpr std::array<MeshFormat, 3> kWritten = {{
    {"obj", "Wavefront OBJ"},
    {"ply", "Stanford PLY"},
    {"glb", "glTF binary"},
}};

/// Lower case, without the dot.
std::string extensionOf(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  if (!extension.empty()) extension.erase(0, 1);
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension;
}

}  // namespace

std::span<const MeshFormat> meshWriteFormats() { return kWritten; }

bool canWriteMesh(const std::filesystem::path& file) {
  const std::string extension = extensionOf(file);
  return std::any_of(kWritten.begin(), kWritten.end(),
                     [&](const MeshFormat& format) { return extension == format.extension; });
}

std::string meshBytes(const std::filesystem::path& file, const ChartedMesh& charted,
                      const MeshWriteOptions& options) {
  const std::string extension = extensionOf(file);
  if (extension == "obj") return objText(charted, options.obj);
  if (extension == "ply") return plyBytes(charted, options.ply);
  if (extension == "glb") return glbBytes(charted, options.glb);
  throw UsageError("Could not write " + file.string() +
                   ": meshes are written to files that end in .obj, .ply or .glb.");
}

void writeMesh(const std::filesystem::path& file, const ChartedMesh& charted,
               const MeshWriteOptions& options) {
  writeFileAtomically(file, meshBytes(file, charted, options));
}

}  // namespace chartflood
