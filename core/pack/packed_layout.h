#pragma once
/// Charts at one scale, turned and packed by their shapes.

#include <span>
#include <vector>

#include "core/base/progress.h"
#include "core/model/atlas.h"
#include "core/pack/chart_outline.h"
#include "core/pack/squeeze.h"

namespace chartflood {

/// A coarse layout of upright charts, found in milliseconds. \return one entry an outline
/// \pre as below
std::vector<Placement> firstLayout(std::span<const ChartOutline> outlines, const PackGaps& gaps);

/// The first layout, or a denser one where a search finds it.
/// \return one entry an outline; meaningless when cancelled
/// \pre the gaps leave room for all outlines
std::vector<Placement> packedLayout(std::span<const ChartOutline> outlines, const PackGaps& gaps,
                                    Progress& progress);

}  // namespace chartflood
