#pragma once
/// How thick a flat outline is.

#include <span>

#include <glm/vec2.hpp>

namespace chartflood {

/// The smaller of the least distance between two parallel lines that hold all points, and 4 area /
/// perimeter (the hydraulic diameter, which sees strips that bend; exact for disks and squares,
/// twice the width for long strips). Units of the points.
/// `area` and `perimeter` are those of the outline; `points` hold its corners, in any order.
double thickness(std::span<const glm::dvec2> points, double area, double perimeter);

}  // namespace chartflood
