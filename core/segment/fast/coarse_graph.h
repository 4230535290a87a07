#pragma once
/// A mesh seen from afar: compact clusters of faces with delays between them, on which a round of
/// flooding costs a small part of one on the faces.

#include <cstddef>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "core/base/rng.h"
#include "core/segment/fast/node_graph.h"
#include "core/segment/parts/face_clusters.h"
#include "core/segment/parts/part_shares.h"

namespace chartflood {

/// Nodes are clusters. The delay from one to another is the distance of their centroids times the
/// mean of their slownesses; a cluster's slowness is the harmonic mean of delay over distance on
/// the ways into its faces, weighted by their lengths.
struct CoarseGraph {
  NodeGraph nodes;
  std::vector<Index> start;      ///< the face that stands for each node as a seed
  std::vector<Index> component;  ///< of the mesh that each node is in
  std::vector<glm::dvec3> center;

  std::size_t nodeCount() const { return nodes.nodeCount(); }
};

/// Faces a cluster: enough clusters that `charts` charts can be even, few enough to be fast.
std::size_t coarseClusterSize(std::size_t faces, std::size_t charts);

/// \param clusters by clusterFaces(), of all charts at once
/// Cost: linear, a few passes.
CoarseGraph makeCoarseGraph(const NodeGraphSource& source, FaceClusters clusters);

/// Seeds far apart as by placeSeeds(), nodes for faces. \pre there are `count` nodes, and the given
/// ones are distinct
std::vector<Index> placeCoarseSeeds(const CoarseGraph& graph, std::size_t components,
                                    std::size_t count, std::span<const Index> given,
                                    const PartShares& shares, Rng& rng);

}  // namespace chartflood
