#pragma once
/// Slits long fingers of a chart open (paper section 3.6).

#include "core/model/chart_set.h"

namespace chartflood {

/// While the vertex farthest from the boundary (the highest of the local maxima, which the paper
/// looks at) lies at least `tip` times the boundary's length away from it, cuts from there to the
/// boundary along the shortest path. The boundary grows with each cut.
/// \param tip above 0; 1 in the paper
/// \pre chart.disk()
void cutTips(CutChart& chart, double tip);

}  // namespace chartflood
