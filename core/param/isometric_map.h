#pragma once
/// From a map without flips to one with as little distortion as possible, still without flips.

#include <vector>

#include <glm/vec2.hpp>

#include "core/base/progress.h"
#include "core/param/chart_shape.h"

namespace chartflood {

struct IsometricOptions {
  int steps = 8;               ///< at most
  double tolerance = 1e-4;     ///< relative fall of the energy at which to stop
  bool guardBoundary = false;  ///< refuse steps that make the boundary touch itself
  bool fixBoundary = false;    ///< move inner vertices alone
};

/// Minimises the mean symmetric Dirichlet energy by Newton steps. Triangles stay counter-clockwise
/// in each. Reweighted steps come first while they take half of the way or more. With
/// `guardBoundary` the map also stays one-to-one: vertices of segments that would cross are held
/// back until they do not. Ends early when cancelled or when no step helps. \param uv all triangles
/// counter-clockwise, chart area about 1; improved in place \return the energy reached, 1 for an
/// isometry
double minimiseIsometric(const ChartShape& shape, const IsometricOptions& options,
                         const Progress& progress, std::vector<glm::dvec2>& uv);

}  // namespace chartflood
