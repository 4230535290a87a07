#pragma once
/// A flood of clusters of faces that is told, stepped and logged face by face.

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "core/flood/flood.h"
#include "core/segment/fast/node_graph.h"

namespace chartflood {

/// Floods the nodes of a graph, clusters with shortest times, and hands out the faces of each node
/// taken, one by one. Without a log whole floods touch no faces.
class NodeFlood {
 public:
  /// The graph must outlive the flood and belong to the mesh.
  NodeFlood(const Mesh& mesh, const NodeGraph& graph, std::size_t charts);

  void start(std::span<const Index> seeds, std::span<const double> offsets, bool lookahead,
             std::shared_ptr<FloodRecord> record);
  /// Takes up to `count` more faces; returns how many. Stops early when cancelled.
  std::size_t take(std::size_t count, Progress* progress);
  std::size_t taken() const { return taken_; }
  bool finished() const { return taken_ == graph_.nodeOfFace.size(); }

  /// Chart of each face, kNone while free.
  std::vector<Index> labels() const;
  /// Chart of each node of a finished flood.
  std::vector<Index> nodeLabels() const;
  Flood& flood() { return *flood_; }

 private:
  std::size_t handOut(std::size_t count);

  const Mesh& mesh_;
  const NodeGraph& graph_;
  std::unique_ptr<Flood> flood_;
  std::shared_ptr<FloodRecord> nodeLog_, record_;
  mutable std::unique_ptr<NodeFaces> faces_;  ///< made when first needed
  std::size_t taken_ = 0;                     ///< faces
  std::size_t nodesOut_ = 0;                  ///< nodes whose faces are all handed out
  std::size_t outOfNext_ = 0;                 ///< faces handed out of the node after those
};

/// Chart of each face from those of the nodes.
std::vector<Index> projectLabels(const NodeGraph& graph, std::span<const Index> nodeLabel);

}  // namespace chartflood
