#pragma once
/// How much of the sphere a polygon winds around, and how often.

#include <span>

#include "core/gauss/spherical_polygon.h"

namespace chartflood {

/// polygonArea() for any polygon, by cutting the sphere into slices between meridians.
PolygonArea windingArea(std::span<const glm::dvec3> corners);

}  // namespace chartflood
