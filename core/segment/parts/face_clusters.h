#pragma once
/// Clusters of neighbouring faces inside charts: the coarse graphs of the seam cuts.

#include <cstddef>
#include <span>
#include <vector>

#include "core/base/index.h"
#include "core/model/mesh.h"

namespace chartflood {

/// Which cluster each face is in. Clusters are connected, hold faces of one chart only, and are
/// numbered without gaps.
struct FaceClusters {
  std::vector<Index> ofFace;
  std::size_t count = 0;
  std::size_t firstFixed = 0;  ///< clusters from here on lie far from all seams
  std::vector<Index> start;    ///< face that each cluster was begun with; of clusterFaces() only
};

/// Every `size`-th face starts a cluster, and one breadth-first search inside the charts shares out
/// the rest. With size 1 every face is a cluster. Cost: linear.
/// \param label chart of each face; empty: all are in one
/// \param alsoStarts more faces that start a cluster, ascending
FaceClusters clusterFaces(const Mesh& mesh, std::span<const Index> label, std::size_t size,
                          std::span<const Index> alsoStarts = {});

/// Faces up to `rings` steps from a seam are clusters of their own; each connected rest of a chart
/// is one big cluster. Cost: linear.
FaceClusters clusterNearSeams(const Mesh& mesh, std::span<const Index> label, std::size_t rings);

/// The distinct clusters around a vertex, in the order of its sides.
/// \param around takes them
/// \return whether faces go all around the vertex
bool clustersAround(const Mesh& mesh, std::span<const Index> ofFace, Index vertex,
                    std::vector<Index>& around);

}  // namespace chartflood
