#pragma once
/// Index types of the flat arrays.

#include <cstdint>

namespace chartflood {

/// Numbers vertices, triangles, faces, sides, edges and charts in flat arrays.
using Index = std::uint32_t;

/// No element: a border's opposite side, a free face's chart.
inline constexpr Index kNone = 0xFFFFFFFFu;

}  // namespace chartflood
