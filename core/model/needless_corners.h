#pragma once
/// Corners of faces that say the same place twice, a part of triangulateFaces().

#include <cstddef>
#include <vector>

#include "core/model/input_mesh.h"

namespace chartflood {

/// Corners at the end of an edge of no length, between different vertices, that one face alone has:
/// its vertices will be one. Engines write such quads and triangles around poles. Ascending places
/// in InputMesh::corners.
///
/// A triangle would be left out for it. It is where two other faces then meet in its place, as
/// around a pole; else it stays, thin as it is. Cost: one look at every edge, in parallel; another
/// where any has no length.
std::vector<std::size_t> needlessCorners(const InputMesh& input);

}  // namespace chartflood
