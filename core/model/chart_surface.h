#pragma once
/// One chart as a surface of its own: its triangles, glued across the edges that are neither seam,
/// mesh border nor cut. A mesh vertex on such an edge may stand here several times.

#include <array>
#include <cstddef>
#include <vector>

#include <glm/vec3.hpp>

#include "core/base/index.h"

namespace chartflood {

/// Local numbers throughout; *side* 3 t + i runs from corner i of triangle t to corner i + 1, as in
/// Mesh. Every vertex owns exactly one fan of triangles.
struct ChartSurface {
  std::vector<Index> meshTriangle;              ///< of each triangle, ascending
  std::vector<std::array<Index, 3>> triangles;  ///< vertices, counter-clockwise
  std::vector<Index> opposite;                  ///< side across each side; kNone on the boundary
  std::vector<Index> meshVertex;                ///< that each vertex stands for
  std::vector<glm::dvec3> positions;            ///< of each vertex, normalised units
  /// Of each side: a diagonal inside a polygon, which no cut may follow. Empty: there is none.
  std::vector<bool> diagonal;

  std::size_t triangleCount() const { return triangles.size(); }
  std::size_t vertexCount() const { return positions.size(); }
  Index sideStart(Index side) const { return triangles[side / 3][side % 3]; }
  Index sideEnd(Index side) const { return triangles[side / 3][side % 3 == 2 ? 0 : side % 3 + 1]; }
  static Index nextSide(Index side) { return side % 3 == 2 ? side - 2 : side + 1; }
  static Index previousSide(Index side) { return side % 3 == 0 ? side + 2 : side - 1; }
  bool isDiagonal(Index side) const { return !diagonal.empty() && diagonal[side]; }
  /// The side of the mesh that a side stands for.
  Index meshSide(Index side) const { return 3 * meshTriangle[side / 3] + side % 3; }
};

/// What decides whether a surface is a disk.
struct ChartTopology {
  long euler = 0;                 ///< V - E + F
  std::size_t boundaryLoops = 0;  ///< closed chains of boundary sides
  std::size_t pieces = 0;         ///< parts connected across edges
  /// Handles; defined for one piece.
  long genus() const { return (2 - static_cast<long>(boundaryLoops) - euler) / 2; }
  bool disk() const { return pieces == 1 && euler == 1 && boundaryLoops == 1; }

  bool operator==(const ChartTopology&) const = default;
};

}  // namespace chartflood
