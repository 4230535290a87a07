#pragma once
/// The exact way to lay a developable chart flat: its triangles are turned into the plane about
/// their edges, one after the other, however thin they are.

#include <vector>

#include <glm/vec2.hpp>

#include "core/param/chart_shape.h"

namespace chartflood {

/// The place of each vertex when every triangle keeps its exact shape; empty when places that are
/// reached in several ways clearly differ (inner vertices with Gauss curvature). The longest edges
/// are turned about first, as their directions are the most exact.
/// Cost: n log n for n triangles.
std::vector<glm::dvec2> unfold(const ChartSurface& surface);

/// The unfolded chart, its area about 1, if it has no stretch, no flips and no overlap; empty
/// otherwise.
std::vector<glm::dvec2> unfoldedMap(const ChartShape& shape);

}  // namespace chartflood
