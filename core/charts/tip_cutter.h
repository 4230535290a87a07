#pragma once
/// Slits long fingers of a chart open (paper section 3.6).

#include "core/model/chart_set.h"

namespace chartflood {

/// Cuts from every local maximum of the distance to the boundary that is at least `tip` times the
/// boundary's length away from it, farthest first, along the shortest path to the boundary or to a
/// cut made before. Distances and length are those of the final boundary loop, before the first of
/// these cuts, as the paper has it: of equal fingers each is slit. Maxima that lie closer together
/// than the mesh can tell, the way between them going down by less than a mean edge, are one.
/// \param tip above 0; 1 in the paper
/// \pre chart.disk()
void cutTips(CutChart& chart, double tip);

}  // namespace chartflood
