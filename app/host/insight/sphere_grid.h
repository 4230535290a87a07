#pragma once
/// A grid over the unit sphere that counts how often each place is covered.

#include <cstddef>
#include <vector>

#include <glm/vec3.hpp>

namespace chartflood {

struct SphereFacet;

/// The six sides of a cube, each in squares of about the same solid angle.
class SphereGrid {
 public:
  static constexpr int kCells = 48;  ///< along a side of the cube
  /// About half the side of a cell, so that pieces this small rarely skip one; radians.
  static constexpr float kCellSide = 0.022f;

  SphereGrid();

  /// Adds `area` steradians to the cell that holds the direction (any length but 0).
  void add(const glm::vec3& direction, float area);
  /// Marks the cell as reached though nothing covers it.
  void touch(const glm::vec3& direction);

  /// One facet for each cell that was reached, in the order of the grid.
  std::vector<SphereFacet> facets() const;
  /// Solid angle of all cells that were reached, steradians.
  double reached() const;

 private:
  std::size_t cellOf(const glm::vec3& direction) const;

  std::vector<float> area_;  ///< covered, of each cell; negative: not reached
};

}  // namespace chartflood
