#pragma once
/// The one list of mesh formats: reading, writing, file browser, help, messages and README come
/// from it.

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/io/text/source.h"
#include "core/io/write/charted_mesh.h"
#include "core/io/write/write_glb.h"
#include "core/io/write/write_obj.h"
#include "core/io/write/write_ply.h"
#include "core/model/input_mesh.h"

namespace chartflood {

/// Who reads a format.
enum class FormatReader {
  Own,     ///< a reader of this program: everything that belongs to the surface is read
  Library  ///< the import library, in a program of its own: tried, as well as the library knows it
};

/// How well the beginning of a file fits a format.
enum class FormatFit {
  No,
  Loose,    ///< as much text would
  Likely,   ///< but other formats may begin so
  Certain,  ///< nothing else begins so
};

/// Used by the format that they belong to.
struct MeshWriteOptions {
  ObjOptions obj;
  PlyOptions ply;
  GlbOptions glb;
};

/// One row of the list.
struct MeshFormat {
  const char* extension;  ///< lower case, without the dot
  const char* title;      ///< "Wavefront OBJ"
  /// Null: the import library reads it.
  InputMesh (*read)(const Source&) = nullptr;
  /// Null: only its name tells it.
  FormatFit (*fit)(const Source&) = nullptr;
  /// The content of a file. Null: it is not written.
  std::string (*write)(const ChartedMesh&, const MeshWriteOptions&) = nullptr;
  /// What a written file holds, as a sentence for whoever chooses the format.
  const char* keeps = "";

  FormatReader reader() const {
    return read == nullptr ? FormatReader::Library : FormatReader::Own;
  }
};

/// Every format that readMesh() takes, own readers first; those that are written, the best one
/// first.
std::span<const MeshFormat> meshFormats();

/// The format of an extension, with or without its dot, in any case; null when it is not listed.
const MeshFormat* findMeshFormat(std::string_view extension);

/// The format with an own reader whose content this is; null when there is none.
const MeshFormat* formatOfContent(const Source& source);

/// ".obj, .ply, .off" of one kind of reader.
std::string extensionList(FormatReader reader);

/// ".obj", ".ply", ".glb": of those that are written.
std::vector<std::string> writtenExtensions();

/// "Wavefront OBJ (.obj)", one row each, as a Markdown table of both kinds of reader.
std::string formatTable();

}  // namespace chartflood
