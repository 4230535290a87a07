#include "core/io/write_mesh.h"

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/io/write/file_output.h"

namespace chartflood {

namespace {

const MeshFormat* writtenFormat(const std::filesystem::path& file) {
  const MeshFormat* const format = findMeshFormat(file.extension().string());
  return format != nullptr && format->write != nullptr ? format : nullptr;
}

}  // namespace

bool canWriteMesh(const std::filesystem::path& file) { return writtenFormat(file) != nullptr; }

std::string meshBytes(const std::filesystem::path& file, const ChartedMesh& charted,
                      const MeshWriteOptions& options) {
  const MeshFormat* const format = writtenFormat(file);
  if (format == nullptr) {
    throw UsageError("Could not write " + file.string() +
                     ": meshes are written to files that end in " +
                     listed(writtenExtensions(), "or") + ".");
  }
  return format->write(charted, options);
}

void writeMesh(const std::filesystem::path& file, const ChartedMesh& charted,
               const MeshWriteOptions& options) {
  writeFileAtomically(file, meshBytes(file, charted, options));
}

}  // namespace chartflood
