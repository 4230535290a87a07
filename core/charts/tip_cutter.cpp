#include "core/charts/tip_cutter.h"

#include <cmath>

#include "core/charts/boundary_cut.h"
#include "core/charts/chart_surface.h"

namespace chartflood {

namespace {

double boundaryLength(const ChartSurface& surface) {
  double length = 0;
  for (Index side = 0; side < surface.opposite.size(); ++side) {
    if (surface.opposite[side] == kNone) length += sideLength(surface, side);
  }
  return length;
}

}  // namespace

void cutTips(CutChart& chart, double tip) {
  while (true) {
    const std::vector<double> distance = distanceToBoundary(chart.surface);
    Index farthest = kNone;
    double most = 0;
    for (Index v = 0; v < distance.size(); ++v) {
      if (std::isfinite(distance[v]) && distance[v] > most) {
        most = distance[v];
        farthest = v;
      }
    }
    if (farthest == kNone || most < tip * boundaryLength(chart.surface)) return;
    if (!cutToBoundary(chart, farthest, CutReason::Tip)) return;
  }
}

}  // namespace chartflood
