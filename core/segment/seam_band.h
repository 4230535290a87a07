#pragma once
/// The faces near the seams of given charts, set free to be flooded again from what is left of each
/// chart: evens out Gauss area and straightens seams at once.

#include <cstddef>
#include <span>
#include <vector>

#include "core/segment/node_graph.h"

namespace chartflood {

/// Nodes are the freed faces and behind them the rests of the charts, which are the seeds. Delays
/// are distances between centroids: the band is to be shared out evenly, whatever its curvature.
struct SeamBand {
  NodeGraph nodes;
  std::size_t freeFaces = 0;  ///< nodes below this are single faces
  std::vector<Index> seeds;   ///< rest of each chart
};

/// Frees the faces up to `rings` steps over sides from a seam. Of each chart the connected rest
/// that holds its seed stays, else the largest and the way to it from the seed, else the seed
/// alone. \param label chart of each face; charts are connected \param seeds a face of each chart
/// Cost: linear.
SeamBand makeSeamBand(const NodeGraphSource& source, std::span<const Index> label,
                      std::span<const Index> seeds, std::size_t rings);

}  // namespace chartflood
