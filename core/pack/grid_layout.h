#pragma once
/// Charts in equal square cells, row by row from the upper left.

#include <span>
#include <vector>

#include "core/model/atlas.h"
#include "core/pack/chart_outline.h"
#include "core/pack/squeeze.h"

namespace chartflood {

/// Side of the cells of a grid of ceil(sqrt(count)) columns; at most 0 when the gaps leave none.
double gridCell(std::size_t count, const PackGaps& gaps);

/// Each chart turned to its smallest enclosing square, in the middle of its cell.
/// \param oneScale all charts at the scale of the largest, or each as large as its cell allows
/// \return one entry an outline
/// \pre gridCell(outlines.size(), gaps) > 0
std::vector<Placement> gridLayout(std::span<const ChartOutline> outlines, const PackGaps& gaps,
                                  bool oneScale);

}  // namespace chartflood
