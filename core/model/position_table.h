#pragma once
/// Numbers for places in space: equal ones get equal numbers.

#include <cstddef>
#include <vector>

#include <glm/vec3.hpp>

#include "core/base/index.h"

namespace chartflood {

/// Numbers distinct positions in the order in which they are met. Positions are equal when all bits
/// are, with -0 taken as 0.
class PositionTable {
 public:
  explicit PositionTable(std::size_t expected = 0);
  /// The number of the position; a new one is appended to positions().
  Index indexOf(glm::dvec3 position);
  /// The number of the position; kNone when it has none.
  Index find(glm::dvec3 position) const;
  std::vector<glm::dvec3>& positions() { return positions_; }

 private:
  std::size_t slotOf(const glm::dvec3& position) const;
  void grow();

  std::vector<glm::dvec3> positions_;
  std::vector<Index> slots_;  ///< open addressing, kNone is free; a power of two of them
};

/// Whether two positions are one place, as in a PositionTable.
bool samePlace(const glm::dvec3& a, const glm::dvec3& b);

/// Numbers places that lie apart by more than a distance: a position takes the number of the
/// nearest earlier place within that distance, or is a new place. Which places there are depends on
/// the order in which positions come.
class NearPlaces {
 public:
  explicit NearPlaces(double distance) : distance_(distance) {}
  Index indexOf(const glm::dvec3& position);

 private:
  double distance_;
  std::vector<glm::dvec3> places_;
  std::vector<Index> next_;  ///< the next place of the same cell; kNone: the last
  PositionTable cells_;
  std::vector<Index> first_;  ///< of each cell
};

}  // namespace chartflood
