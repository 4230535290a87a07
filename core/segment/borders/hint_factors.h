#pragma once
/// Painted edges as what they count in a seam's length.

#include <memory>
#include <span>
#include <vector>

#include "core/model/edge_hints.h"
#include "core/model/mesh.h"

namespace chartflood {

/// Factor on the length of each side of the mesh: 0.02 where a cut is welcome, 50 where none is to
/// be, else 1. Null without hints. Hints at edges that the mesh does not have count for nothing.
std::shared_ptr<const std::vector<double>> hintFactors(const Mesh& mesh,
                                                       std::span<const EdgeHint> hints);

}  // namespace chartflood
