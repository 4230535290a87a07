#pragma once
/// Draws the two sides of closed slits apart.

#include <vector>

#include <glm/vec2.hpp>

#include "core/param/chart_shape.h"

namespace chartflood {

/// Moves boundary vertices that lie on another part of the boundary (a planar ring that was cut
/// open closes again in the plane) towards their own triangles by about 1/100 of their edges, so
/// that nobody welds the two sides by their places. No triangle flips.
/// \param uv all triangles counter-clockwise
/// \return true when no part of the boundary touches or crosses another any more
bool partSlits(const ChartShape& shape, std::vector<glm::dvec2>& uv);

}  // namespace chartflood
