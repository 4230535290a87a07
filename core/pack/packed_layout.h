#pragma once
/// Charts at one scale, turned and packed by their shapes.

#include <span>
#include <vector>

#include "core/base/progress.h"
#include "core/model/atlas.h"
#include "core/pack/chart_outline.h"
#include "core/pack/squeeze.h"

namespace chartflood {

/// \return one entry an outline; meaningless when cancelled
/// \pre the gaps leave room for all outlines
std::vector<Placement> packedLayout(std::span<const ChartOutline> outlines, const PackGaps& gaps,
                                    Progress& progress);

}  // namespace chartflood
