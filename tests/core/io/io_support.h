#pragma once
/// Files for a test that vanish after it, and short ways to read them.

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/model/input_mesh.h"
#include "core/model/mesh.h"
#include "tests/support/temporary_folder.h"

namespace chartflood::test {

std::shared_ptr<const InputMesh> readFile(const std::filesystem::path& file);
/// Reads `bytes` as a file with this name.
std::shared_ptr<const InputMesh> readBytes(const std::string& name, std::string_view bytes);
/// The same through buildMesh().
std::shared_ptr<const Mesh> buildBytes(const std::string& name, std::string_view bytes);
/// The cause with which a file of this name is refused, "" when it is read.
std::string refusalOf(const std::string& name, std::string_view bytes);

/// All faces as lists of vertices.
std::vector<std::vector<Index>> facesOf(const InputMesh& mesh);
/// How often the repair is reported, 0 when it is not.
std::size_t countOf(std::span<const Repair> repairs, std::string_view what);
/// Input vertices that triangles use, welded ones once.
std::size_t usedVertices(const Mesh& mesh);

std::string readWholeFile(const std::filesystem::path& file);

/// Bytes of a value, least significant first, or most significant first.
template <class T>
std::string bytesOf(T value, bool bigEndian = false) {
  std::string bytes(reinterpret_cast<const char*>(&value), sizeof value);
  if (bigEndian) bytes = std::string(bytes.rbegin(), bytes.rend());
  return bytes;
}

}  // namespace chartflood::test
