#pragma once
/// The free unwrap: no flips, no overlap, little stretch.

#include <vector>

#include <glm/vec2.hpp>

#include "core/base/progress.h"
#include "core/param/chart_shape.h"

namespace chartflood {

/// Area about 1. Starts from a conformal map; where that leads to flips or overlap, from `before`
/// (the map of the chart before its last cut, or empty) and failing that from a circle.
/// \return empty when cancelled, or when no map without flips was found
std::vector<glm::dvec2> freeMap(const ChartShape& shape, const std::vector<glm::dvec2>& before,
                                const Progress& progress);

}  // namespace chartflood
