#pragma once
/// What growing charts by normals needs to know of every face, packed for it.

#include <array>
#include <limits>
#include <vector>

#include <glm/vec3.hpp>

#include "core/base/index.h"
#include "core/model/mesh.h"

namespace chartflood {

/// One face with its place in the flood under way, half a cache line.
struct alignas(32) GrowthFace {
  glm::vec3 normal{0};  ///< unit; 0 for a degenerate face
  float area = 0;       ///< squared normalised units; 0 for a degenerate face
  float best = 0;       ///< least key offered so far; the key it was taken with
  Index owner = kNone;  ///< chart that offered it
  Index label = kNone;  ///< chart that took it, kNone while free
};
static_assert(sizeof(GrowthFace) == 32);

/// One way across a face's side.
struct GrowthArc {
  Index face = kNone;  ///< where it leads, kNone across a mesh border
  float length = 0;    ///< between the centroids, normalised units
};

/// Faces with normals, and the dual graph. Faces of a polygon mesh have as many arcs as outer
/// sides.
struct GrowthGraph {
  std::vector<GrowthFace> faces;
  std::vector<Index> arcBegin;  ///< faceCount + 1 entries; empty when every face has three arcs
  std::vector<GrowthArc> arcs;
  double meanLength = 0;  ///< of the arcs that lead somewhere

  Index begin(Index face) const { return arcBegin.empty() ? 3 * face : arcBegin[face]; }
};

/// Sum of the area times unit normal of a face's triangles; 0 for a degenerate face.
glm::dvec3 areaVector(const Mesh& mesh, Index face);

/// Cost: linear, one pass.
GrowthGraph buildGrowthGraph(const Mesh& mesh);

}  // namespace chartflood
