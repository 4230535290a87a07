#include "core/io/read_mesh.h"

#include <algorithm>
#include <new>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "core/base/error.h"
#include "core/base/file_bytes.h"
#include "core/io/mesh_formats.h"
#include "core/io/read/read_assimp.h"
#include "core/io/text/source.h"

namespace chartflood {

namespace {

/// By its content where the name tells nothing; otherwise as its name says.
const MeshFormat& formatOf(const std::filesystem::path& file, const Source& source) {
  const MeshFormat* const known = findMeshFormat(file.extension().string());
  const MeshFormat* const content = formatOfContent(source);
  if (known == nullptr) {
    if (content != nullptr) return *content;
    source.fail("its format is not known; supported are " + extensionList(FormatReader::Own) +
                ", and tried " + extensionList(FormatReader::Library));
  }
  // Only formats with an unmistakable beginning: OBJ and STL readers take nearly anything. One
  // reader may take several endings.
  const bool certain = content != nullptr && content->fit(source) == FormatFit::Certain;
  const bool own = known->reader() == FormatReader::Own;
  if (certain && own && content->read != known->read) {
    source.fail("its content is of the format ." + std::string(content->extension) +
                " although its name ends in ." + std::string(known->extension) +
                "; rename it to end in ." + std::string(content->extension));
  }
  return *known;
}

InputMesh readAs(const MeshFormat& format, const Source& source) {
  return format.read != nullptr ? format.read(source) : readAssimp(source, format.extension);
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
