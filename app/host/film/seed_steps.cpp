#include "app/host/film/seed_steps.h"

#include <algorithm>
#include <vector>

#include <glm/geometric.hpp>

namespace chartflood {

namespace {

constexpr double kLeastCosine = 0.34;  // of about 70 degrees

glm::dvec3 middleOf(const Mesh& mesh, Index face) {
  glm::dvec3 sum(0);
  double count = 0;
  for (Index t = mesh.triangleBegin(face); t < mesh.triangleBegin(face + 1); ++t) {
    for (const Index vertex : mesh.triangles()[t]) sum += mesh.positions()[vertex];
    count += 3;
  }
  return sum / count;
}

/// Other faces with a corner in common, ascending.
std::vector<Index> facesAround(const Mesh& mesh, Index face) {
  std::vector<Index> faces;
  for (Index t = mesh.triangleBegin(face); t < mesh.triangleBegin(face + 1); ++t) {
    for (const Index vertex : mesh.triangles()[t]) {
      const Index first = mesh.vertexSide()[vertex];
      Index side = first;
      while (side != kNone) {
        faces.push_back(mesh.faceOf(side / 3));
        side = mesh.turn(side);
        if (side == first) break;
      }
    }
  }
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  return faces;
}

}  // namespace

Index faceTowards(const Mesh& mesh, Index face, const glm::dvec3& direction,
                  const glm::dvec3& forward, const std::function<bool(Index)>& free) {
  const glm::dvec3 from = middleOf(mesh, face);
  Index best = kNone;
  double bestCosine = kLeastCosine;
  for (const Index each : facesAround(mesh, face)) {
    if (each == face || !free(each)) continue;
    glm::dvec3 way = middleOf(mesh, each) - from;
    way -= forward * glm::dot(way, forward);
    const double length = glm::length(way);
    if (!(length > 0)) continue;
    const double cosine = glm::dot(way, direction) / length;
    if (cosine > bestCosine) {
      bestCosine = cosine;
      best = each;
    }
  }
  return best;
}

glm::dvec3 faceNormal(const Mesh& mesh, Index face) {
  glm::dvec3 sum(0);
  for (Index t = mesh.triangleBegin(face); t < mesh.triangleBegin(face + 1); ++t) {
    const auto& v = mesh.triangles()[t];
    const glm::dvec3 a = mesh.positions()[v[0]];
    sum += glm::cross(mesh.positions()[v[1]] - a, mesh.positions()[v[2]] - a) * 0.5;
  }
  return sum;
}

}  // namespace chartflood
