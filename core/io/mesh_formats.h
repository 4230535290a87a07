#pragma once
/// The one list of mesh formats: reading, file browser, help, messages and README come from it.

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace chartflood {

/// Who reads a format.
enum class FormatReader {
  Own,     ///< a reader of this program: everything that belongs to the surface is read
  Library  ///< the import library, in a program of its own: tried, as well as the library knows it
};

/// One row of the list.
struct MeshFormat {
  const char* extension;                    ///< lower case, without the dot
  const char* title;                        ///< "Wavefront OBJ"
  FormatReader reader = FormatReader::Own;  ///< says nothing of a format that is written
};

/// Every format that readMesh() takes, own readers first.
std::span<const MeshFormat> meshFormats();

/// The format of an extension, with or without its dot, in any case; null when it is not listed.
const MeshFormat* findMeshFormat(std::string_view extension);

/// ".obj, .ply, .off" of one kind of reader.
std::string extensionList(FormatReader reader);

/// "Wavefront OBJ (.obj)", one row each, as a Markdown table of both kinds of reader.
std::string formatTable();

}  // namespace chartflood
