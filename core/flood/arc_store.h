#pragma once
/// Labels of faces of any degree during a flood; the plain counterpart of TriangleStore.

#include <algorithm>
#include <span>
#include <vector>

#include "core/base/index.h"
#include "core/flood/corner_state.h"
#include "core/model/flood_graph.h"

namespace chartflood {

/// Same questions, same answers as TriangleStore (see there), for FloodGraph's arcs.
class ArcStore {
 public:
  explicit ArcStore(const FloodGraph& graph) : graph_(graph), corners_(graph) { reset(); }

  std::size_t faceCount() const { return label_.size(); }
  void reset() {
    label_.assign(graph_.faceCount, kNone);
    corners_.reset();
  }

  bool isFree(Index face) const { return label_[face] == kNone; }
  Index label(Index face) const { return label_[face]; }

  double gain(Index face, Index chart) const {
    double sum = static_cast<double>(graph_.gain[face]);
    for (const FloodArc& arc : arcs(face)) {
      if (label_[arc.face] == chart) sum += static_cast<double>(arc.edgeGain);
    }
    for (Index i = graph_.cornerBegin[face]; i < graph_.cornerBegin[face + 1]; ++i) {
      sum += corners_.gain(graph_.corners[i].corner, graph_.corners[i].times, chart);
    }
    return sum;
  }

  template <class Offer>
  void take(Index face, Index chart, float time, const Offer& offer) {
    label_[face] = chart;
    for (Index i = graph_.cornerBegin[face]; i < graph_.cornerBegin[face + 1]; ++i) {
      corners_.take(graph_.corners[i].corner, graph_.corners[i].times, chart);
    }
    for (const FloodArc& arc : arcs(face)) {
      if (label_[arc.face] != kNone) continue;
      const auto there = arcs(arc.face);
      const auto incidences = std::count_if(there.begin(), there.end(), [&](const FloodArc& back) {
        return label_[back.face] == chart;
      });
      // Two faces that share several edges meet as often; the first of their arcs offers.
      const auto shared = std::count_if(there.begin(), there.end(),
                                        [&](const FloodArc& back) { return back.face == face; });
      if (incidences != shared || !firstArcTo(face, arc)) continue;
      offer(arc.face, time + arc.delay);
    }
  }

  bool onBorder(Index face) const {
    if (graph_.atMeshBorder[face] != 0) return true;
    const auto around = arcs(face);
    return std::any_of(around.begin(), around.end(),
                       [&](const FloodArc& arc) { return label_[arc.face] != label_[face]; });
  }

  template <class Visit>
  void forEachWay(Index face, const Visit& visit) const {
    for (const FloodArc& arc : arcs(face)) visit(arc.face, arc.delay);
  }
  void prefetchWays(Index face) const { prefetchFace(face); }

  void prefetchFace(Index face) const { __builtin_prefetch(&graph_.arcBegin[face]); }
  void prefetchNeighbours(Index) const {}

 private:
  std::span<const FloodArc> arcs(Index face) const {
    return {graph_.arcs.data() + graph_.arcBegin[face],
            graph_.arcs.data() + graph_.arcBegin[face + 1]};
  }
  bool firstArcTo(Index face, const FloodArc& arc) const {
    for (const FloodArc& other : arcs(face)) {
      if (other.face == arc.face) return &other == &arc;
    }
    return false;
  }

  const FloodGraph& graph_;
  std::vector<Index> label_;
  CornerState corners_;
};

}  // namespace chartflood
