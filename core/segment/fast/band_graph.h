#pragma once
/// The graph of the triangles that a seam band frees and of the rests of the charts around them.

#include <cstddef>
#include <span>
#include <vector>

#include "core/segment/fast/node_graph.h"

namespace chartflood {

/// Which faces are free, and the node of every face: free faces are numbered in their order, the
/// rest of chart c comes as node c after them.
struct BandFaces {
  std::vector<Index> free;
  std::vector<Index> nodeOfFace;
};

/// \param rest chart of each cluster that stays, kNone for those that are freed
BandFaces numberBandFaces(const NodeGraph& clusters, std::span<const Index> rest);

/// The graph in the packed layout, with the rests as hubs; delays are distances between centroids.
/// What is inside a rest is summed from the clusters. \pre the source's flood graph is packed
/// Cost: linear in free faces, clusters and sharp edges.
NodeGraph triangleBand(const NodeGraphSource& source, const NodeGraph& clusters,
                       std::span<const Index> rest, std::size_t charts, BandFaces faces);

}  // namespace chartflood
