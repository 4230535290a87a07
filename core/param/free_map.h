#pragma once
/// The free unwrap: no flips, no overlap, little stretch.

#include <vector>

#include <glm/vec2.hpp>

#include "core/base/progress.h"
#include "core/param/chart_shape.h"

namespace chartflood {

/// Scaled to area 1. \return empty when cancelled, or when no map without flips was found
std::vector<glm::dvec2> freeMap(const ChartShape& shape, const Progress& progress);

}  // namespace chartflood
