#pragma once
/// Charts on shelves: rows of boxes, for charts that are too many for a search or have no shapes.

#include <span>
#include <vector>

#include "core/model/atlas.h"
#include "core/pack/chart_outline.h"
#include "core/pack/squeeze.h"

namespace chartflood {

/// Each chart turned to its box of the least area, long side across; boxes stand in rows, tall ones
/// first, all at the largest scale at which the rows fit. Cost: n log n in the charts.
/// \return one entry an outline; empty when no scale above `leastScale` fits
std::vector<Placement> shelfLayout(std::span<const ChartOutline> outlines, const PackGaps& gaps,
                                   double leastScale);

}  // namespace chartflood
