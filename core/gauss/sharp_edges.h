#pragma once
/// Which edges are creases (paper section 3.2: the dihedral angle against T_a).

#include <cstdint>
#include <vector>

#include "core/model/mesh.h"

namespace chartflood {

/// One flag a side, equal on both sides of an edge: 1 when the unit normals of the two triangles
/// differ by more than `sharpAngle` degrees. Borders and edges of degenerate triangles are never
/// sharp; at 180 degrees nothing is. Cost: linear.
std::vector<std::uint8_t> findSharpSides(const Mesh& mesh, double sharpAngle);

}  // namespace chartflood
