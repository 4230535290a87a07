#pragma once
/// Opens a chart that is developable but for a few places: tips of cones, rims of caps.

#include "core/model/chart_set.h"

namespace chartflood {

/// Cuts a tree of edges through all inner vertices with Gauss curvature, each joined to the
/// boundary or to those before it by the shortest way, nearest first. What is left can be unfolded
/// exactly. \param most length of all cuts, over that of the boundary; up to three vertices may
/// take more \return false, and nothing changed, when there is no such vertex, or not enough of a
/// way Cost: about linear. \pre chart.disk()
bool openCones(CutChart& chart, double most);

}  // namespace chartflood
