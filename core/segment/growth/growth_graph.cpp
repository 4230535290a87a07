#include "core/segment/growth/growth_graph.h"

#include <glm/geometric.hpp>

#include "core/flood/build_flood_graph.h"

namespace chartflood {

glm::dvec3 areaVector(const Mesh& mesh, Index face) {
  const auto positions = mesh.positions();
  glm::dvec3 sum{0};
  for (Index t = mesh.triangleBegin(face); t < mesh.triangleBegin(face + 1); ++t) {
    if (mesh.degenerate(t)) continue;
    const auto& corner = mesh.triangles()[t];
    const glm::dvec3 a = positions[corner[0]];
    sum += 0.5 * glm::cross(positions[corner[1]] - a, positions[corner[2]] - a);
  }
  return sum;
}

GrowthGraph buildGrowthGraph(const Mesh& mesh) {
  GrowthGraph graph;
  const std::size_t faces = mesh.faceCount();
  const std::vector<glm::dvec3> centroid = faceCentroids(mesh);
  graph.faces.resize(faces);
  graph.arcs.reserve(3 * faces);
  double sum = 0;
  std::size_t count = 0;
  for (Index f = 0; f < faces; ++f) {
    if (!mesh.facesAreTriangles()) graph.arcBegin.push_back(static_cast<Index>(graph.arcs.size()));
    for (Index t = mesh.triangleBegin(f); t < mesh.triangleBegin(f + 1); ++t) {
      for (Index s = 3 * t; s < 3 * t + 3; ++s) {
        const Index other = mesh.opposite()[s];
        const Index next = other == kNone ? kNone : mesh.faceOf(other / 3);
        if (next == f) continue;  // inside a polygon, or a triangle glued to itself
        const double length = next == kNone ? 0 : glm::length(centroid[f] - centroid[next]);
        graph.arcs.push_back({next, static_cast<float>(length)});
        sum += length;
        count += next != kNone;
      }
      // Every triangle of a triangle mesh has its three arcs, whatever it is glued to.
      while (mesh.facesAreTriangles() && graph.arcs.size() < 3 * (f + std::size_t{1})) {
        graph.arcs.push_back({});
      }
    }
    const glm::dvec3 vector = areaVector(mesh, f);
    const double area = glm::length(vector);
    if (!(area > 0)) continue;
    graph.faces[f].normal = glm::vec3(vector / area);
    graph.faces[f].area = static_cast<float>(area);
  }
  if (!mesh.facesAreTriangles()) graph.arcBegin.push_back(static_cast<Index>(graph.arcs.size()));
  graph.meanLength = count == 0 ? 0 : sum / static_cast<double>(count);
  return graph;
}

}  // namespace chartflood
