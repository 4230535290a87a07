#include "render/scene/surface_vertices.h"

#include <cstddef>

#include <glm/vec3.hpp>

#include "render/scene/packed_normal.h"

namespace chartflood {

std::shared_ptr<const SurfaceVertices> surfaceVertices(const Mesh& mesh,
                                                       const CornerNormals* normals) {
  auto list = std::make_shared<SurfaceVertices>();
  list->hasNormals = normals != nullptr;
  list->vertices.reserve(mesh.vertexCount() + mesh.vertexCount() / 8);
  list->indices.reserve(3 * mesh.triangleCount());
  std::vector<Index> newest(mesh.vertexCount(), kNone);  // entry of a vertex made last
  std::vector<Index> older;                              // of an entry: the one made before
  older.reserve(list->vertices.capacity());
  for (std::size_t t = 0; t < mesh.triangleCount(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Index vertex = mesh.triangles()[t][i];
      const std::uint32_t normal = normals ? packNormal(normals->normal[3 * t + i]) : 0;
      Index entry = newest[vertex];
      while (entry != kNone && list->vertices[entry].normal != normal) entry = older[entry];
      if (entry == kNone) {
        entry = static_cast<Index>(list->vertices.size());
        const glm::vec3 place(mesh.positions()[vertex]);
        list->vertices.push_back({{place.x, place.y, place.z}, normal});
        older.push_back(newest[vertex]);
        newest[vertex] = entry;
      }
      list->indices.push_back(entry);
    }
  }
  return list;
}

std::shared_ptr<const SurfaceVertices> partedVertices(const SurfaceVertices& whole,
                                                      std::span<const glm::vec3> corners) {
  auto parted = std::make_shared<SurfaceVertices>();
  parted->hasNormals = whole.hasNormals;
  parted->indices.reserve(whole.indices.size());
  parted->vertices.reserve(whole.vertices.size() + whole.vertices.size() / 8);
  parted->texture.reserve(parted->vertices.capacity());
  std::vector<Index> newest(whole.vertices.size(), kNone), older;  // as in surfaceVertices()
  older.reserve(parted->vertices.capacity());
  for (std::size_t c = 0; c < corners.size(); ++c) {
    const Index vertex = whole.indices[c];
    Index entry = newest[vertex];
    while (entry != kNone && parted->texture[entry] != corners[c]) entry = older[entry];
    if (entry == kNone) {
      entry = static_cast<Index>(parted->vertices.size());
      parted->vertices.push_back(whole.vertices[vertex]);
      parted->texture.push_back(corners[c]);
      older.push_back(newest[vertex]);
      newest[vertex] = entry;
    }
    parted->indices.push_back(entry);
  }
  return parted;
}

}  // namespace chartflood
