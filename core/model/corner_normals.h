#pragma once
/// Normals for shading: one per triangle corner, split at sharp edges.

#include <vector>

#include <glm/vec3.hpp>

namespace chartflood {

/// `normal[3 t + i]` is the unit sector normal of corner i of triangle t.
struct CornerNormals {
  std::vector<glm::vec3> normal;
};

}  // namespace chartflood
