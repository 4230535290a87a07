#pragma once
/// Joining vertices that lie at exactly the same place.

#include <cstddef>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "core/base/index.h"
#include "core/model/input_mesh.h"

namespace chartflood {

/// Numbers distinct positions in the order in which they are met. Positions are equal when all bits
/// are, with -0 taken as 0.
class PositionTable {
 public:
  explicit PositionTable(std::size_t expected = 0);
  /// The number of the position; a new one is appended to positions().
  Index indexOf(glm::dvec3 position);
  std::vector<glm::dvec3>& positions() { return positions_; }

 private:
  void grow();

  std::vector<glm::dvec3> positions_;
  std::vector<Index> slots_;  ///< open addressing, kNone is free; a power of two of them
};

/// For each vertex the first one at the same place; empty when no two share a place.
std::vector<Index> joinEqualPositions(std::span<const glm::dvec3> positions);

/// True for two or more faces of which no two share a vertex: a file that lists each face with
/// vertices of its own.
bool isUnshared(const InputMesh& mesh);

}  // namespace chartflood
