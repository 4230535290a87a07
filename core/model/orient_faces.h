#pragma once
/// Turning over faces that run against their neighbours, a step of buildMesh().

#include <cstddef>
#include <utility>
#include <vector>

#include "core/model/mesh.h"

namespace chartflood {

/// Turns faces over until edges that two faces use in one direction are glued, as far as the
/// surface can be oriented: edges of faces that agree already are never given up, so a surface that
/// cannot be oriented, such as a Moebius strip, is split where the file's own faces disagree.
///
/// In every connected part the larger number of faces stays, and the one with the smallest number
/// where both are equal.
/// \param conflicts pairs of sides that are one edge run through twice in one direction; those that
///   could not be glued are left in it
/// \returns how many faces were turned
/// Cost: linear when there are conflicts, none otherwise.
std::size_t orientFaces(MeshData& d, std::vector<std::pair<Index, Index>>& conflicts);

}  // namespace chartflood
