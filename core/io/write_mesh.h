#pragma once
/// Charted meshes to files: the one door, whatever the format.

#include <filesystem>
#include <string>

#include "core/io/mesh_formats.h"
#include "core/io/write/charted_mesh.h"

namespace chartflood {

/// True when the file's extension (any case) is of a format that is written.
bool canWriteMesh(const std::filesystem::path& file);

/// The content of a file with this name. \throws UsageError when its extension is of no
/// format that is written; Error as glbBytes(). \pre as chartPlaces()
std::string meshBytes(const std::filesystem::path& file, const ChartedMesh& charted,
                      const MeshWriteOptions& options = {});

/// Writes meshBytes() to the file. \throws as meshBytes(); WriteError, the old file is then as it
/// was.
void writeMesh(const std::filesystem::path& file, const ChartedMesh& charted,
               const MeshWriteOptions& options = {});

}  // namespace chartflood
