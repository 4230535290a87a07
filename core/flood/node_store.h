#pragma once
/// Labels of clusters of faces during a flood with shortest times: the counterpart of TriangleStore
/// for graphs of nodes with any number of neighbours.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/index.h"
#include "core/flood/corner_state.h"
#include "core/model/flood_graph.h"

namespace chartflood {

/// Same questions as TriangleStore (see there), for FloodGraph's arcs; a free neighbour is offered
/// again whenever a way to it is shorter.
class NodeStore {
 public:
  explicit NodeStore(const FloodGraph& graph) : graph_(graph), corners_(graph) {
    nodes_.resize(graph.faceCount);
    special_.assign(graph.faceCount, 0);
    ways_.reserve(graph.arcs.size());
    for (const FloodArc& arc : graph.arcs) ways_.push_back({arc.face, arc.delay});
    for (Index n = 0; n < nodes_.size(); ++n) {
      nodes_[n].gain = graph.gain[n];
      if (graph.cornerBegin[n] != graph.cornerBegin[n + 1]) special_[n] |= kCorners;
      for (Index i = graph.arcBegin[n]; i < graph.arcBegin[n + 1]; ++i) {
        if (graph.arcs[i].edgeGain > 0) special_[n] |= kEdges;
      }
    }
    reset();
  }

  std::size_t faceCount() const { return nodes_.size(); }
  void reset() {
    for (Node& node : nodes_) node.label = node.lastChart = kNone;
    corners_.reset();
  }

  bool isFree(Index face) const { return nodes_[face].label == kNone; }
  Index label(Index face) const { return nodes_[face].label; }

  double gain(Index face, Index chart) const {
    double sum = static_cast<double>(nodes_[face].gain);
    if (special_[face] == 0) return sum;
    if ((special_[face] & kEdges) != 0) {
      for (Index i = graph_.arcBegin[face]; i < graph_.arcBegin[face + 1]; ++i) {
        if (nodes_[ways_[i].face].label == chart) {
          sum += static_cast<double>(graph_.arcs[i].edgeGain);
        }
      }
    }
    for (Index i = graph_.cornerBegin[face]; i < graph_.cornerBegin[face + 1]; ++i) {
      sum += corners_.gain(graph_.corners[i].corner, graph_.corners[i].times, chart);
    }
    return sum;
  }

  template <class Offer>
  void take(Index face, Index chart, float time, const Offer& offer) {
    nodes_[face].label = chart;
    if ((special_[face] & kCorners) != 0) {
      for (Index i = graph_.cornerBegin[face]; i < graph_.cornerBegin[face + 1]; ++i) {
        corners_.take(graph_.corners[i].corner, graph_.corners[i].times, chart);
      }
    }
    const std::span<const Way> ways = waysOf(face);
    // Which ways offer is anyone's guess: collected without branches, a few at a time.
    constexpr std::size_t kTogether = 8;
    struct {
      Index face;
      float arrival;
    } offers[kTogether];
    for (std::size_t i = 0; i < ways.size();) {
      std::size_t count = 0;
      for (const std::size_t stop = std::min(ways.size(), i + kTogether); i < stop; ++i) {
        const Way way = ways[i];
        Node& there = nodes_[way.face];
        const float arrival = time + way.delay;
        // Most nodes are offered to one chart only, which need not hear of later times.
        const bool late = (there.lastChart == chart) & (there.lastTime <= arrival);
        const bool news = (there.label == kNone) & !late;
        offers[count] = {way.face, arrival};
        count += news ? 1 : 0;
      }
      for (std::size_t k = 0; k < count; ++k) {
        Node& there = nodes_[offers[k].face];
        there.lastChart = chart;
        there.lastTime = offers[k].arrival;
        offer(offers[k].face, offers[k].arrival);
      }
    }
  }

  bool onBorder(Index face) const {
    if (graph_.atMeshBorder[face] != 0) return true;
    const Index own = nodes_[face].label;
    for (const Way& way : waysOf(face)) {
      if (nodes_[way.face].label != own) return true;
    }
    return false;
  }

  template <class Visit>
  void forEachWay(Index face, const Visit& visit) const {
    for (const Way& way : waysOf(face)) visit(way.face, way.delay);
  }

  // Nodes are few enough for the cache.
  void prefetchFace(Index) const {}
  void prefetchNeighbours(Index) const {}
  void prefetchWays(Index) const {}

 private:
  struct Way {
    Index face;
    float delay;
  };
  /// What others ask of a node, a quarter of a cache line.
  struct alignas(16) Node {
    float gain = 0;
    Index label = kNone;
    Index lastChart = kNone;  ///< that was offered the node last, and for when
    float lastTime = 0;
  };
  static constexpr std::uint8_t kEdges = 1, kCorners = 2;

  std::span<const Way> waysOf(Index face) const {
    return {ways_.data() + graph_.arcBegin[face], ways_.data() + graph_.arcBegin[face + 1]};
  }

  const FloodGraph& graph_;
  std::vector<Node> nodes_;
  std::vector<std::uint8_t> special_;  ///< of each node: has edges or corners with Gauss area
  std::vector<Way> ways_;
  CornerState corners_;
};

}  // namespace chartflood
