#pragma once
/// First seeds: far apart from each other (paper section 3.4).

#include <span>
#include <vector>

#include "core/base/rng.h"
#include "core/model/mesh.h"
#include "core/segment/parts/part_shares.h"

namespace chartflood {

/// Number of charts in force: every component needs one and those that are small come on top, as
/// countWithParts() has it; a seed that is there has a chart; no more than there are faces.
/// \param seeds that are given
std::size_t effectiveChartCount(const Mesh& mesh, std::size_t requested, std::size_t seeds = 0);

/// \throws UsageError when a given seed is no face of the mesh or is given twice.
void checkSeeds(const Mesh& mesh, std::span<const Index> given);

/// Chooses `count` distinct faces (effectiveChartCount says how many are possible).
///
/// `given` seeds come first, in their order. Without any, the first is uniformly random. Then one
/// random face in each component that has none. Then, until there are enough, the face farthest
/// from all seeds over the dual graph with distances between centroids, lowest number on ties. One
/// search from all seeds, updated where a new seed is nearer, takes no more than one or two floods.
///
/// Beyond the paper, for meshes of several components, between which charts cannot move: each
/// further seed goes to the component with the largest weight per seed, so that charts of all
/// components can come out equal, and of those with the most seeds they may have only when no other
/// has a face to spare.
/// \throws UsageError when a given seed is no face of the mesh or is given twice.
std::vector<Index> placeSeeds(const Mesh& mesh, std::size_t count, std::span<const Index> given,
                              const PartShares& shares, Rng& rng);

/// How many seeds to add to `present` on the way to `wanted`: one, as the papers do, and a share
/// of 1/32 where there are many, so that many charts take few rounds.
std::size_t seedsToAdd(std::size_t present, std::size_t wanted);

}  // namespace chartflood
