#pragma once
/// Gluing sides that run between the same two vertices, a step of buildMesh().

#include <cstddef>
#include <utility>
#include <vector>

#include "core/model/mesh.h"

namespace chartflood {

/// What could not be glued. Sides ascend.
struct GlueFindings {
  std::size_t nonManifoldEdges = 0;
  std::vector<Index> nonManifoldSides;  ///< of edges that more than two triangles use
  /// Two sides, the smaller first, of an edge that exactly two triangles use in one direction.
  std::vector<std::pair<Index, Index>> conflicts;
};

/// Finds for each side without an opposite one the only other one between its vertices, if that
/// runs the other way; notes slits of polygons in `d`. Cost: linear, in parallel.
GlueFindings glueEdges(MeshData& d, std::size_t vertexCount);

}  // namespace chartflood
