#pragma once
/// Charts with their boundary on a circle (paper section 4).

#include <vector>

#include <glm/vec2.hpp>

#include "core/base/progress.h"
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

/// The circle map with the least isometric energy that has no flips; empty when there is none.
std::vector<glm::dvec2> bestCircleMap(const ChartShape& shape);

/// Moves the inside of a circle map away from conformal until its triangles are sturdy: where a
/// long finger shrinks to nothing, its triangles would flip when places are rounded. \return empty
/// when that cannot be reached
std::vector<glm::dvec2> sturdyCircleMap(const ChartShape& shape, const Progress& progress);

}  // namespace chartflood
