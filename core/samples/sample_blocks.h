#pragma once
/// Surfaces of unit cubes put together.

#include <array>
#include <vector>

#include "core/model/input_mesh.h"

namespace chartflood {

/// The surface of a union of unit cubes, named by their smallest corners. Cubes must meet in whole
/// squares, or the surface is not manifold.
InputMesh makeBlocks(const std::vector<std::array<int, 3>>& cells, double edge);

}  // namespace chartflood
