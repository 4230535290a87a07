#pragma once
/// The dual graph of a mesh with clusters of faces as nodes, ready to be flooded: what the fast
/// search runs on instead of single faces.

#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "core/base/index.h"
#include "core/model/flood_graph.h"
#include "core/model/gauss_area.h"
#include "core/model/mesh.h"

namespace chartflood {

/// A flood graph (arcs; delays are left to the caller) over connected clusters of faces, with the
/// Gauss area of everything in double precision: charts of whole clusters have the same Gauss area
/// as on the mesh.
struct NodeGraph {
  std::vector<Index> nodeOfFace;
  FloodGraph flood;
  std::vector<double> gauss;  ///< of each node: its faces, edges and corners wholly inside
  /// A sharp edge between two nodes.
  struct Edge {
    Index a, b;
    double gauss;
  };
  std::vector<Edge> edges;
  std::vector<Index> cornerNodeBegin;  ///< into cornerNode, one entry more than corners
  std::vector<Index> cornerNode;       ///< nodes around each corner that touches several
  std::vector<double> cornerGauss;     ///< of each such corner

  std::size_t nodeCount() const { return gauss.size(); }
  /// The label that all nodes around a corner have, kNone when they differ.
  Index commonOf(std::size_t corner, std::span<const Index> nodeLabel) const;
  /// A(c) of charts of nodes, steradians. Cost: linear in nodes.
  std::vector<double> chartGauss(std::span<const Index> nodeLabel, std::size_t charts) const;
};

/// What buildNodeGraph() takes from the stages before.
struct NodeGraphSource {
  const Mesh& mesh;
  const GaussArea& gauss;
  std::span<const double> faceGauss;
  const FloodGraph& flood;  ///< of the faces: eta
};

/// Nodes as given; arcs between nodes that share a side, once for each pair, heads ascending.
/// \param sideOfArc becomes the first side of the mesh that each arc crosses
/// Cost: linear, apart from sorting the arcs of each node.
NodeGraph buildNodeGraph(const NodeGraphSource& source, std::vector<Index> nodeOfFace,
                         std::size_t nodes, std::vector<Index>& sideOfArc);

/// The faces of each node, from one of its lowest numbered face on in steps over sides, so that
/// every beginning of the list is connected when the node is.
struct NodeFaces {
  std::vector<Index> begin;  ///< one entry more than nodes
  std::vector<Index> face;

  NodeFaces(const Mesh& mesh, std::span<const Index> nodeOfFace, std::size_t nodes);
  std::span<const Index> of(Index node) const {
    return {face.data() + begin[node], face.data() + begin[node + 1]};
  }
};

}  // namespace chartflood
