#pragma once
/// Cuts from an inner vertex to the boundary: for tips and for relief of stretch.

#include "core/model/chart_set.h"

namespace chartflood {

/// Distance of every vertex to the boundary along edges that may be cut, normalised units; infinite
/// where there is no way.
std::vector<double> distanceToBoundary(const ChartSurface& surface);

/// Whether the vertex is on the boundary. Cost: linear.
bool isOnBoundary(const ChartSurface& surface, Index vertex);

/// Opens a disk along the shortest path of edges from an inner vertex to the boundary (ties to the
/// lower vertex number), appends the cut to `chart.cuts` and updates its topology. The chart stays
/// a disk. False, and nothing changed, when there is no such path.
/// \pre chart.disk(), `vertex` is not on the boundary
bool cutToBoundary(CutChart& chart, Index vertex, CutReason reason);

}  // namespace chartflood
