#pragma once
/// Meshes from files: the one door, whatever the format.

#include <filesystem>
#include <memory>
#include <string>

#include "core/base/progress.h"
#include "core/model/input_mesh.h"

namespace chartflood {

/// Reads the vertices and faces of a mesh file, in the order of the file, polygons kept.
///
/// The format follows from the extension (any case): OBJ, PLY (ASCII and binary), OFF, STL (ASCII
/// and binary), glTF/GLB, 3MF, and what the import library opens besides (meshFormats()); when the
/// extension is missing or unknown, from the content. Coordinates are in the file's units; glTF,
/// 3MF and library formats have their node transforms applied. Findings of the reader are in
/// InputMesh::repairs; gluing and dropping is the work of buildMesh().
///
/// \param progress may be null; its phase is "Reading". Cancelling returns null.
/// \throws ReadError for anything that cannot be read as a mesh: not a regular file, not readable,
///   an unsupported format, broken content (with its line or byte), no faces.
/// Cost: about 1 s per GB of binary PLY and 3 s per GB of text or binary STL (whose corners have to
/// be joined), plus reading from disk.
std::shared_ptr<const InputMesh> readMesh(const std::filesystem::path& file,
                                          Progress* progress = nullptr);

}  // namespace chartflood
