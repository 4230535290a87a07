#pragma once
/// Charted meshes to files: the one door, whatever the format.

#include <filesystem>
#include <span>
#include <string>

#include "core/io/mesh_formats.h"
#include "core/io/write/charted_mesh.h"
#include "core/io/write/write_glb.h"
#include "core/io/write/write_obj.h"
#include "core/io/write/write_ply.h"

namespace chartflood {

/// Used by the format that they belong to.
struct MeshWriteOptions {
  ObjOptions obj;
  PlyOptions ply;
  GlbOptions glb;
};

/// Every format that meshBytes() gives, the best one first: OBJ, PLY, GLB.
std::span<const MeshFormat> meshWriteFormats();

/// True when the file's extension (any case) is one of meshWriteFormats().
bool canWriteMesh(const std::filesystem::path& file);

/// The content of a file with this name. \throws UsageError when its extension is none of
/// meshWriteFormats(); Error as glbBytes(). \pre as chartPlaces()
std::string meshBytes(const std::filesystem::path& file, const ChartedMesh& charted,
                      const MeshWriteOptions& options = {});

/// Writes meshBytes() to the file. \throws as meshBytes(); WriteError, the old file is then as it
/// was.
void writeMesh(const std::filesystem::path& file, const ChartedMesh& charted,
               const MeshWriteOptions& options = {});

}  // namespace chartflood
