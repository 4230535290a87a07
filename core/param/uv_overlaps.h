#pragma once
/// Triangles of the texture that lie over others.

#include <array>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

namespace chartflood {

using PlaneTriangle = std::array<glm::dvec2, 3>;

/// Marks each triangle that another one overlaps: no line along a side of either parts them, by
/// more than `least` (units of the plane; above 0). What is nowhere thicker than that, and what has
/// a corner that is not finite, overlaps nothing.
/// Cost: about linear for triangles that are spread evenly (uniform grid), the square of those that
/// share a corner. \throws Interrupted
std::vector<bool> findOverlaps(std::span<const PlaneTriangle> triangles, double least);

}  // namespace chartflood
