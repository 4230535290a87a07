#include "io_support.h"

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <set>
#include <stdexcept>

#include "core/base/error.h"
#include "core/io/read_mesh.h"
#include "core/model/build_mesh.h"

namespace chartflood::test {

std::shared_ptr<const InputMesh> readFile(const std::filesystem::path& file) {
  return readMesh(file);
}

std::shared_ptr<const InputMesh> readBytes(const std::string& name, std::string_view bytes) {
  const TemporaryFolder folder;
  return readMesh(folder.write(name, bytes));
}

std::shared_ptr<const Mesh> buildBytes(const std::string& name, std::string_view bytes) {
  return buildMesh(readBytes(name, bytes));
}

std::string refusalOf(const std::string& name, std::string_view bytes) {
  try {
    buildBytes(name, bytes);
  } catch (const ReadError& e) {
    return e.cause();
  }
  return "";
}

std::vector<std::vector<Index>> facesOf(const InputMesh& mesh) {
  std::vector<std::vector<Index>> faces;
  for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
    const auto face = mesh.face(f);
    faces.emplace_back(face.begin(), face.end());
  }
  return faces;
}

std::size_t countOf(std::span<const Repair> repairs, std::string_view what) {
  for (const Repair& repair : repairs) {
    if (repair.what == what) return repair.count;
  }
  return 0;
}

std::size_t usedVertices(const Mesh& mesh) {
  std::set<Index> used;
  for (const auto& triangle : mesh.triangles()) {
    for (const Index vertex : triangle) used.insert(mesh.inputVertex(vertex));
  }
  return used.size();
}

std::string readWholeFile(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace chartflood::test
