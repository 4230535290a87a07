#pragma once
/// Where a word fits best inside an outline.

#include <vector>

#include <glm/vec2.hpp>

namespace chartflood {

/// Closed polygons; a point is inside where it is encircled an odd number of times.
using Outline = std::vector<std::vector<glm::dvec2>>;

struct LabelPoint {
  glm::dvec2 at{0};
  double room = 0;  ///< distance to the outline; 0 when nothing is inside
};

/// A point inside that is far from the outline: the best of the middles of what a few horizontal
/// lines cut out. Cost: linear in the outline's length, about 50 times.
LabelPoint labelPoint(const Outline& outline);

}  // namespace chartflood
