#pragma once
/// Cuts a polygon in space into triangles over its own corners, so that it stays one disk whatever
/// its outline does.

#include <array>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "core/base/index.h"

namespace chartflood {

/// Keeps its memory from polygon to polygon.
///
/// Corners that repeat the one before them and spikes that run to a vertex and back bound nothing
/// and are left out, as long as anything is left. What remains is fanned from its first corner
/// where that gives no triangle turned against the polygon's plane (Newell's normal), as in every
/// convex polygon. Others, concave ones, holes written as slits and outlines that touch themselves,
/// have their ears clipped, those with the shortest diagonals first. n corners give n - 2
/// triangles, all facing the polygon's side where that is possible at all: a polygon that crosses
/// itself has no such triangles and still gets n - 2.
class PolygonTriangulator {
 public:
  /// Corners of a triangle, as places in the list of the polygon's vertices.
  using Triangle = std::array<Index, 3>;

  /// \param polygon vertices in order; a vertex may come more than once
  /// Cost: linear for fans; else about n log n for outlines without many corners in one spot.
  void run(std::span<const Index> polygon, std::span<const glm::dvec3> positions);

  std::span<const Triangle> triangles() const { return triangles_; }
  /// Sides 3 t + i of the triangles that are the two sides of one diagonal.
  std::span<const std::pair<Index, Index>> diagonals() const { return diagonals_; }

 private:
  void dropRepeats(std::span<const Index> polygon);
  void dropSpikes(std::span<const Index> polygon);
  bool fan(std::span<const Index> polygon, std::span<const glm::dvec3> positions);
  void addTriangle(Index a, Index b, Index c);

  std::vector<Index> loop_, spikeless_;  ///< corners that count
  glm::dvec3 normal_{0};                 ///< twice the area, after Newell
  std::vector<Triangle> triangles_;
  std::vector<std::pair<Index, Index>> diagonals_;
};

}  // namespace chartflood
