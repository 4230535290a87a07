#pragma once
/// Which charts can be made more even: those that share a border with another.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/index.h"
#include "core/model/mesh.h"

namespace chartflood {

/// 1 for each chart with a neighbour, 0 for those that are all of their part: a crumb's chart stays
/// as it is and says nothing about how large others are to be. All 1 where none has a neighbour.
/// Cost: a pass over the sides.
std::vector<std::uint8_t> borderedCharts(const Mesh& mesh, std::span<const Index> label,
                                         std::size_t charts);

}  // namespace chartflood
