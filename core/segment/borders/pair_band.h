#pragma once
/// The part of two neighbouring charts that a cut between them may move.

#include <utility>
#include <vector>

#include "core/base/index.h"
#include "core/segment/borders/seam_state.h"

namespace chartflood {

/// Distances and nodes of a search; storage is kept.
using BandHeap = std::vector<std::pair<double, Index>>;

/// The nodes of charts a and b within the state's band of their common seam, over distances between
/// centres, fixed ones left out. Writes the distances, and in `local` the place of each node found.
/// \param band takes the nodes, those of a first, each chart's ascending
/// \return false when there is no common seam or nothing that may move
bool findBand(SeamState& state, Index a, Index b, BandHeap& heap, std::vector<Index>& band);

}  // namespace chartflood
