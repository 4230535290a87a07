#include "tests/support/test_meshes.h"

#include <filesystem>
#include <numeric>
#include <random>

#include "core/io/read_mesh.h"
#include "core/model/build_mesh.h"
#include "core/samples/samples.h"

namespace chartflood::test {

std::shared_ptr<const Mesh> rebuild(InputMesh input) {
  return buildMesh(std::make_shared<const InputMesh>(std::move(input)));
}

std::shared_ptr<const Mesh> meshOf(std::vector<glm::dvec3> positions, const Polygons& faces) {
  InputMesh input;
  input.file = "test";
  input.positions = std::move(positions);
  input.faceStart.push_back(0);
  for (const auto& face : faces) {
    input.corners.insert(input.corners.end(), face.begin(), face.end());
    input.faceStart.push_back(input.corners.size());
  }
  return rebuild(std::move(input));
}

std::shared_ptr<const Mesh> sampleMesh(const std::string& id, std::size_t triangles) {
  return buildMesh(makeSample(id, triangles));
}

std::shared_ptr<const Mesh> realMesh(const std::string& file) {
  const std::filesystem::path path = std::filesystem::path(CHARTFLOOD_MESHES) / file;
  if (!std::filesystem::exists(path)) return nullptr;
  return buildMesh(readMesh(path));
}

std::shared_ptr<const Mesh> quadCube() {
  std::vector<glm::dvec3> p;
  for (int i = 0; i < 8; ++i) p.emplace_back(i / 4, i / 2 % 2, i % 2);
  return meshOf(
      p, {{0, 1, 3, 2}, {4, 6, 7, 5}, {0, 4, 5, 1}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 5, 7, 3}});
}

std::shared_ptr<const Mesh> grid(Index n, bool triangles) {
  std::vector<glm::dvec3> p;
  Polygons faces;
  for (Index y = 0; y <= n; ++y) {
    for (Index x = 0; x <= n; ++x) p.emplace_back(x, y, 0);
  }
  for (Index y = 0; y < n; ++y) {
    for (Index x = 0; x < n; ++x) {
      const Index a = y * (n + 1) + x, b = a + 1, c = b + n + 1, d = a + n + 1;
      if (triangles) {
        faces.push_back({a, b, c});
        faces.push_back({a, c, d});
      } else {
        faces.push_back({a, b, c, d});
      }
    }
  }
  return meshOf(p, faces);
}

std::size_t repairCount(const Mesh& mesh, std::string_view what) {
  for (const Repair& r : mesh.repairs()) {
    if (r.what == what) return r.count;
  }
  return 0;
}

InputMesh shuffledFaces(const InputMesh& input, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::vector<std::size_t> order(input.faceCount());
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random() % i]);
  InputMesh out = input;
  out.corners.clear();
  out.faceStart.assign(1, 0);
  for (const std::size_t f : order) {
    const auto face = input.face(f);
    const std::size_t first = random() % face.size();
    for (std::size_t i = 0; i < face.size(); ++i) {
      out.corners.push_back(face[(first + i) % face.size()]);
    }
    out.faceStart.push_back(out.corners.size());
  }
  return out;
}

InputMesh copyInput(const Mesh& mesh) { return mesh.input(); }

}  // namespace chartflood::test
