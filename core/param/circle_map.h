#pragma once
/// Charts with their boundary on a circle (paper section 3.7).

#include <vector>

#include <glm/vec2.hpp>

#include "core/param/chart_shape.h"

namespace chartflood {

/// Weights of the edges inside.
enum class CircleWeights {
  Conformal,  ///< the cotangents of the angles across each edge, clamped to be positive
  Uniform,    ///< 1 (Tutte 1963)
};

/// Places the boundary on a circle about the origin by arc length (an arc is at least 1/100 of the
/// mean, so that no two places meet) and every inner vertex at the weighted mean of its neighbours.
/// Positive weights and a convex boundary exclude flips but for rounding (Floater 1997). Scaled to
/// area 1. \return empty when the system cannot be solved or the result is not finite
std::vector<glm::dvec2> circleMap(const ChartShape& shape, CircleWeights weights);

}  // namespace chartflood
