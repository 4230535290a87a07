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
/// again whenever a way to it is shorter. What a step asks of a neighbour lies in half a cache
/// line.
class NodeStore {
 public:
  explicit NodeStore(const FloodGraph& graph) : graph_(graph), corners_(graph) {
    nodes_.resize(graph.faceCount);
    ways_.reserve(graph.arcs.size());
    for (const FloodArc& arc : graph.arcs) ways_.push_back({arc.face, arc.delay});
    for (Index n = 0; n < nodes_.size(); ++n) {
      Node& node = nodes_[n];
      node.begin = graph.arcBegin[n];
      node.end = graph.arcBegin[n + 1];
      node.gain = graph.gain[n];
      node.atMeshBorder = graph.atMeshBorder[n] != 0;
      node.hasCorners = graph.cornerBegin[n] != graph.cornerBegin[n + 1];
      for (Index i = node.begin; i < node.end; ++i) {
        node.hasEdges = node.hasEdges || graph.arcs[i].edgeGain > 0;
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

  void take(Index face, Index chart) {
    nodes_[face].label = chart;
    if (!nodes_[face].hasCorners) return;
    for (Index i = graph_.cornerBegin[face]; i < graph_.cornerBegin[face + 1]; ++i) {
      corners_.take(graph_.corners[i].corner, graph_.corners[i].times, chart);
    }
  }

  double gain(Index face, Index chart) const {
    const Node& node = nodes_[face];
    double sum = static_cast<double>(node.gain);
    if (node.hasEdges) {
      for (Index i = node.begin; i < node.end; ++i) {
        if (nodes_[ways_[i].face].label == chart) {
          sum += static_cast<double>(graph_.arcs[i].edgeGain);
        }
      }
    }
    if (node.hasCorners) {
      for (Index i = graph_.cornerBegin[face]; i < graph_.cornerBegin[face + 1]; ++i) {
        sum += corners_.gain(graph_.corners[i].corner, graph_.corners[i].times, chart);
      }
    }
    return sum;
  }

  template <class Offer>
  void forEachOffer(Index face, Index chart, float time, const Offer& offer) {
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
    const Node& node = nodes_[face];
    if (node.atMeshBorder) return true;
    for (const Way& way : waysOf(face)) {
      if (nodes_[way.face].label != node.label) return true;
    }
    return false;
  }

  template <class Visit>
  void forEachInside(Index face, const Visit& visit) const {
    for (const Way& way : waysOf(face)) {
      if (nodes_[way.face].label == nodes_[face].label) visit(way.face, way.delay);
    }
  }

  void prefetchFace(Index face) const { __builtin_prefetch(&nodes_[face], 1); }
  void prefetchNeighbours(Index face) const {
    // More than a few neighbours have those of clusters, which are few enough for the cache.
    if (waysOf(face).size() > 3) return;
    for (const Way& way : waysOf(face)) __builtin_prefetch(&nodes_[way.face], 1);
  }

 private:
  struct Way {
    Index face;
    float delay;
  };
  struct alignas(32) Node {
    Index begin = 0, end = 0;  ///< of ways_
    float gain = 0;
    Index label = kNone;
    Index lastChart = kNone;  ///< that was offered the node last, and for when
    float lastTime = 0;
    bool atMeshBorder = false, hasEdges = false, hasCorners = false;
  };

  std::span<const Way> waysOf(Index face) const {
    return {ways_.data() + nodes_[face].begin, ways_.data() + nodes_[face].end};
  }

  const FloodGraph& graph_;
  std::vector<Node> nodes_;
  std::vector<Way> ways_;
  CornerState corners_;
};

}  // namespace chartflood
