#pragma once
/// Where the number of each chart has most room in a picture. No GL.

#include <cstddef>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "core/base/index.h"

namespace chartflood {

/// Where a chart's number may stand in a picture.
struct ChartLabel {
  Index chart = kNone;
  glm::vec2 place{0};  ///< pixels from the top left
  float room = 0;      ///< free pixels around it inside the visible chart
};

/// The most interior pixel of each chart that is seen, by chart. `chart` holds the chart of each
/// pixel, kNone where there is none, row by row from the top, all below `chartCount`.
std::vector<ChartLabel> interiorPlaces(std::span<const Index> chart, int width, int height,
                                       std::size_t chartCount);

}  // namespace chartflood
