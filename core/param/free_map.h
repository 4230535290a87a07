#pragma once
/// The free unwrap: no flips, no overlap, little stretch.

#include <vector>

#include <glm/vec2.hpp>

#include "core/base/progress.h"
#include "core/param/chart_shape.h"

namespace chartflood {

/// Area about 1. The direct map where there is one, else the guarded one. \return empty when
/// cancelled, or when no map without flips was found
std::vector<glm::dvec2> freeMap(const ChartShape& shape, const Progress& progress);

/// In a few steps from a conformal map; empty when triangles flip on the way or the chart covers
/// itself.
std::vector<glm::dvec2> directMap(const ChartShape& shape, const Progress& progress);

/// The direct map after fewer steps, for a look while values are dragged: it stretches hardly more.
/// Empty as the direct map is.
std::vector<glm::dvec2> sketchedMap(const ChartShape& shape, const Progress& progress);

/// From a circle, never leaving one-to-one maps.
std::vector<glm::dvec2> guardedMap(const ChartShape& shape, const Progress& progress);

/// Without flips, but it may cover itself: about what the chart stretches at least, for a small
/// part of the time of a guarded map. \param start all triangles counter-clockwise, area about 1
std::vector<glm::dvec2> looseMap(const ChartShape& shape, std::vector<glm::dvec2> start,
                                 const Progress& progress);

/// A loose map brought to its end; empty when the chart covers itself there.
std::vector<glm::dvec2> settledMap(const ChartShape& shape, std::vector<glm::dvec2> loose,
                                   const Progress& progress);

}  // namespace chartflood
