#pragma once
/// Writes a path of a chart down as a cut.

#include <span>

#include "core/charts/chart_surface.h"
#include "core/model/chart_set.h"

namespace chartflood {

/// The cut along the given sides of the surface; nothing is opened.
inline Cut makeCut(const ChartSurface& surface, CutReason reason, std::span<const Index> sides) {
  Cut cut;
  cut.reason = reason;
  cut.sides.reserve(sides.size());
  for (const Index side : sides) {
    cut.sides.push_back(surface.meshSide(side));
    cut.length += sideLength(surface, side);
  }
  return cut;
}

}  // namespace chartflood
