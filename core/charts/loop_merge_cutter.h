#pragma once
/// LoopMergeCutter (paper section 3.6): joins the boundary loops of a chart into one.

#include <vector>

#include "core/model/chart_set.h"

namespace chartflood {

/// From the longest boundary loop (ties to the one with the smallest side) distances grow along the
/// edges; the loop that is reached first is joined by the shortest path, whose inner vertices are
/// inner vertices of the chart, and grows along. Opens the surface and returns the cuts in the
/// order in which they are found: one less than there are loops, fewer when some cannot be reached.
/// Cost: about that of one search for shortest paths.
std::vector<Cut> mergeLoops(ChartSurface& surface);

/// Opens a closed chart without handles along a shortest path of at least two edges between two
/// vertices that are far apart: the one farthest from the first vertex, and the one farthest from
/// that. No cut when there is no such path.
std::vector<Cut> openClosed(ChartSurface& surface);

}  // namespace chartflood
