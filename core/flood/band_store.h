#pragma once
/// Labels of triangles around hubs during a flood: the counterpart of TriangleStore for graphs in
/// which all that stays of each chart is one node.

#include <cstring>
#include <limits>
#include <span>
#include <vector>

#include "core/base/index.h"
#include "core/flood/corner_state.h"
#include "core/model/flood_graph.h"

namespace chartflood {

/// Same questions, same answers as ArcStore (see there), as fast as TriangleStore: nodes below
/// FloodGraph::firstHub have at most three arcs, one to each neighbour; those from there on have
/// any number and must all be seeds. `Label` is an unsigned type that holds every chart number and
/// two more values.
template <class Label>
class BandStore {
 public:
  explicit BandStore(const FloodGraph& graph) : graph_(graph), corners_(graph) {
    records_.resize(graph.firstHub);
    dry_.resize(graph.faceCount);
    for (Index n = 0; n < dry_.size(); ++n) {
      dry_[n] = {kFree, {kWall, kWall, kWall}};
      if (n < graph.firstHub) fill(records_[n], n);
    }
    words_.resize(dry_.size());
    reset();
  }

  static constexpr std::size_t kMaxCharts = std::numeric_limits<Label>::max() - 1;

  std::size_t faceCount() const { return words_.size(); }
  void reset() {
    std::memcpy(words_.data(), dry_.data(), dry_.size() * sizeof(Word));
    corners_.reset();
  }

  bool isFree(Index node) const { return words_[node].own == kFree; }
  Index label(Index node) const { return words_[node].own == kFree ? kNone : words_[node].own; }

  void take(Index node, Index chart) {
    const Label label = static_cast<Label>(chart);
    words_[node].own = label;
    if (isHub(node)) {
      for (const FloodArc& arc : arcs(node)) {
        if (!isHub(arc.face)) words_[arc.face].across[sideOf(arc)] = label;
      }
      takeCorners(node, chart);
      return;
    }
    const FloodFace& record = records_[node];
    for (const Index n : record.neighbour) {
      if (n != kNone) words_[n >> 2].across[n & 3] = label;
    }
    if (record.extra != 0) takeCorners(node, chart);
  }

  double gain(Index node, Index chart) const {
    if (!isHub(node) && records_[node].extra == 0) return static_cast<double>(records_[node].gain);
    double sum = static_cast<double>(graph_.gain[node]);
    for (const FloodArc& arc : arcs(node)) {
      if (words_[arc.face].own == chart) sum += static_cast<double>(arc.edgeGain);
    }
    for (const FloodCorner& c : corners(node)) sum += corners_.gain(c.corner, c.times, chart);
    return sum;
  }

  template <class Offer>
  void forEachOffer(Index node, Index chart, float time, const Offer& offer) const {
    if (isHub(node)) {
      for (const FloodArc& arc : arcs(node)) {
        if (isHub(arc.face) || !isFree(arc.face) || !touchesOnce(arc.face, chart)) continue;
        offer(arc.face, time + arc.delay);
      }
      return;
    }
    const FloodFace& record = records_[node];
    const Word word = words_[node];
    // As in TriangleStore.
    struct {
      Index face;
      float arrival;
    } offers[3];
    std::size_t count = 0;
    for (int k = 0; k < 3; ++k) {
      const bool free = word.across[k] == kFree;
      const Index neighbour = free ? record.neighbour[k] >> 2 : node;
      offers[count] = {neighbour, time + record.delay[k]};
      count += free & touchesOnce(neighbour, chart) ? 1 : 0;
    }
    for (std::size_t i = 0; i < count; ++i) offer(offers[i].face, offers[i].arrival);
  }

  bool onBorder(Index node) const {
    if (graph_.atMeshBorder[node] != 0) return true;
    for (const FloodArc& arc : arcs(node)) {
      if (words_[arc.face].own != words_[node].own) return true;
    }
    return false;
  }

  template <class Visit>
  void forEachInside(Index node, const Visit& visit) const {
    for (const FloodArc& arc : arcs(node)) {
      if (words_[arc.face].own == words_[node].own) visit(arc.face, arc.delay);
    }
  }

  void prefetchFace(Index node) const {
    __builtin_prefetch(&records_[node]);
    __builtin_prefetch(&words_[node], 1);
  }
  void prefetchNeighbours(Index node) const {
    for (const Index n : records_[node].neighbour) {
      if (n != kNone) __builtin_prefetch(&words_[n >> 2], 1);
    }
  }

 private:
  struct Word {
    Label own;
    Label across[3];  ///< of the neighbours by arcs
  };
  static constexpr Label kFree = std::numeric_limits<Label>::max();
  static constexpr Label kWall = kFree - 1;  ///< beyond a mesh border, or a hub not taken yet

  bool isHub(Index node) const { return node >= graph_.firstHub; }
  std::span<const FloodArc> arcs(Index node) const {
    return {graph_.arcs.data() + graph_.arcBegin[node],
            graph_.arcs.data() + graph_.arcBegin[node + 1]};
  }
  std::span<const FloodCorner> corners(Index node) const {
    return {graph_.corners.data() + graph_.cornerBegin[node],
            graph_.corners.data() + graph_.cornerBegin[node + 1]};
  }
  /// Number of the arc back among those of the node that it leads to.
  Index sideOf(const FloodArc& arc) const { return arc.reverse - graph_.arcBegin[arc.face]; }

  bool touchesOnce(Index node, Index chart) const {
    const Word& word = words_[node];
    const Label mark = static_cast<Label>(chart);
    return (word.across[0] == mark) + (word.across[1] == mark) + (word.across[2] == mark) == 1;
  }

  void takeCorners(Index node, Index chart) {
    for (const FloodCorner& c : corners(node)) corners_.take(c.corner, c.times, chart);
  }

  void fill(FloodFace& record, Index node) {
    record = {{kNone, kNone, kNone}, {0, 0, 0}, graph_.gain[node], 0};
    if (!corners(node).empty()) record.extra = 1;
    std::size_t k = 0;
    for (const FloodArc& arc : arcs(node)) {
      if (arc.edgeGain > 0) record.extra = 1;
      if (!isHub(arc.face)) {
        record.neighbour[k] = 4 * arc.face + sideOf(arc);
        record.delay[k] = arc.delay;
        dry_[node].across[k] = kFree;
      }
      ++k;
    }
  }

  const FloodGraph& graph_;
  std::vector<FloodFace> records_;
  std::vector<Word> dry_, words_;
  CornerState corners_;
};

}  // namespace chartflood
