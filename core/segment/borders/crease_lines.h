#pragma once
/// Which sharp edges are creases of the shape, and which are the roughness of its surface.

#include <cstdint>
#include <vector>

#include "core/model/gauss_area.h"
#include "core/model/mesh.h"

namespace chartflood {

/// One flag per entry of gauss.sharpEdges: 1 for creases that seams may follow. Seams that go from
/// one short sharp edge of a rough surface to the next get longer and follow nothing.
///
/// Where sharp edges meet, those that go on straightest are one chain, if they turn by less than 60
/// degrees; where two meet alone they are one whatever their turn. A chain is a line when
/// - it has eight edges or more,
/// - or is at least 0.15 of the square root of its part's surface long,
/// - or is part of a net of four edges or more that has at most one dead end for twenty edges.
/// In parts where other chains are longer than lines, all together, those are roughness; elsewhere
/// they are where lines fade out, and count as these.
/// Cost: n log n in the sharp edges, and a pass over the triangles.
std::vector<std::uint8_t> creaseLines(const Mesh& mesh, const GaussArea& gauss);

}  // namespace chartflood
