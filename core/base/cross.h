#pragma once
/// The plane's cross product, which GLM has for space only.

#include <glm/vec2.hpp>

namespace chartflood {

/// Twice the signed area of the triangle 0, a, b; positive where b lies to the left of a.
inline double cross(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

}  // namespace chartflood
