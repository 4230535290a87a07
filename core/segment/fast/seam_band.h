#pragma once
/// The clusters of faces at the seams of a coarse round, set free to be flooded again face by face
/// from what is left of each chart: evens out Gauss area and straightens seams at once.

#include <cstddef>
#include <span>
#include <vector>

#include "core/segment/fast/node_graph.h"

namespace chartflood {

/// Nodes are the freed faces and behind them the rests of the charts, which are the seeds. Delays
/// are distances between centroids: the band is to be shared out evenly, whatever its curvature.
struct SeamBand {
  NodeGraph nodes;
  std::size_t freeFaces = 0;  ///< nodes below this are single faces
  std::vector<Index> seeds;   ///< rest of each chart
};

/// Frees the clusters at a seam and those up to `rings` - 1 steps from them. Of each chart the
/// connected rest that holds its seed stays, else the one of most clusters and the way to it from
/// the seed, else the cluster of the seed alone.
/// \param clusters as by makeCoarseGraph() \param label chart of each cluster; charts are connected
/// \param seeds a cluster of each chart \param rings 1 or more
/// Cost: linear in clusters, freed faces and sharp edges; one look at each face.
SeamBand makeSeamBand(const NodeGraphSource& source, const NodeGraph& clusters,
                      std::span<const Index> label, std::span<const Index> seeds,
                      std::size_t rings);

}  // namespace chartflood
