#pragma once
/// The files that the import library may open: the mesh itself and what lies in its folder or
/// below.

#include <filesystem>
#include <string>
#include <string_view>

namespace Assimp {
class IOSystem;
}

namespace chartflood {

/// \param folder of the mesh, absolute: the library puts it before the names that it finds
/// \param mesh content of the mesh file, which outlives the result
/// \returns for Assimp::Importer::SetIOHandler(), which takes it over. Files open for reading only,
///   and only regular ones, wherever names and links lead. Nothing is written, made or removed.
Assimp::IOSystem* newFolderFiles(const std::filesystem::path& folder, const std::string& meshName,
                                 std::string_view mesh);

}  // namespace chartflood
