#pragma once
/// Labels of triangular faces during a flood: every face also knows its neighbours' labels, so that
/// a step reads one word and no neighbour's record.

#include <cstring>
#include <limits>
#include <span>
#include <vector>

#include "core/base/index.h"
#include "core/base/raw_vector.h"
#include "core/flood/corner_state.h"
#include "core/model/flood_graph.h"

namespace chartflood {

/// \tparam Label an unsigned type that holds every chart number and two more values
/// \tparam kHubs the graph has hubs behind its triangles; their distance to borders is not asked
/// for
template <class Label, bool kHubs = false>
class TriangleStore {
 public:
  explicit TriangleStore(const FloodGraph& graph) : graph_(graph), corners_(graph) {
    dry_.assign(graph.faceCount, {kFree, {kWall, kWall, kWall}});
    for (std::size_t f = 0; f < graph.faces.size(); ++f) {
      for (int k = 0; k < 3; ++k) {
        if (graph.faces[f].neighbour[k] != kNone) dry_[f].across[k] = kFree;
      }
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

  bool isFree(Index face) const { return words_[face].own == kFree; }
  Index label(Index face) const { return words_[face].own == kFree ? kNone : words_[face].own; }

  /// Labels the face, tells its neighbours, and calls `offer(neighbour, arrival)` for each free one
  /// that no other face of the chart has offered before ("first incidence").
  template <class Offer>
  void take(Index face, Index chart, float time, const Offer& offer) {
    if (isHub(face)) return takeHub(face, chart, time, offer);
    const Label label = static_cast<Label>(chart);
    const FloodFace& record = graph_.faces[face];
    // Which sides offer is anyone's guess: collected without branches, and one branch on how many.
    // Words are read as a whole before any label is written: a read that meets a part written just
    // before waits until the write has reached the cache.
    struct {
      Index face;
      float arrival;
    } offers[3];
    std::size_t count = 0;
    for (int k = 0; k < 3; ++k) {
      const Index n = record.neighbour[k];
      if (n == kNone) continue;
      Word& there = words_[n >> 2];
      const Word before = there;
      there.across[n & 3] = label;
      const bool met =
          (before.across[0] == label) | (before.across[1] == label) | (before.across[2] == label);
      offers[count] = {n >> 2, time + record.delay[k]};
      count += (before.own == kFree) & !met ? 1 : 0;
    }
    words_[face].own = label;
    if (record.extra != 0) {
      for (const Index corner : graph_.extras[record.extra].corner) {
        if (corner != kNone) corners_.take(corner, 1, chart);
      }
    }
    for (std::size_t i = 0; i < count; ++i) offer(offers[i].face, offers[i].arrival);
  }

  /// Gauss area (plus eta times area) that `chart` gains by the face (Delta A_G of section 3.3).
  /// Few single-precision terms added in double: exact in any order.
  double gain(Index face, Index chart) const {
    if (isHub(face)) return static_cast<double>(hub(face).gain);
    const FloodFace& record = graph_.faces[face];
    if (record.extra == 0) return static_cast<double>(record.gain);
    const FloodExtra& extra = graph_.extras[record.extra];
    double sum = static_cast<double>(record.gain);
    for (int k = 0; k < 3; ++k) {
      if (words_[face].across[k] == chart) sum += static_cast<double>(extra.edge[k]);
      if (extra.corner[k] != kNone) sum += corners_.gain(extra.corner[k], 1, chart);
    }
    return sum;
  }

  /// True when the face touches another chart or the mesh border.
  bool onBorder(Index face) const {
    const Word& word = words_[face];
    return word.across[0] != word.own || word.across[1] != word.own || word.across[2] != word.own;
  }

  /// Calls `visit(neighbour, delay)` for each neighbour, whatever its chart.
  template <class Visit>
  void forEachWay(Index face, const Visit& visit) const {
    if (isHub(face)) return;
    const FloodFace& record = graph_.faces[face];
    for (int k = 0; k < 3; ++k) {
      if (record.neighbour[k] != kNone) visit(record.neighbour[k] >> 2, record.delay[k]);
    }
  }
  /// Fetches what forEachWay() reads, which taking the face reads as well.
  void prefetchWays(Index face) const { __builtin_prefetch(graph_.faces.data() + face); }

  void prefetchFace(Index face) const {
    __builtin_prefetch(graph_.faces.data() + face);
    __builtin_prefetch(&words_[face], 1);
  }
  /// Fetches what taking the face will write; its record should be at hand already.
  void prefetchNeighbours(Index face) const {
    if (isHub(face)) return;
    for (const Index n : graph_.faces[face].neighbour) {
      if (n != kNone) __builtin_prefetch(&words_[n >> 2], 1);
    }
  }

 private:
  bool isHub(Index face) const { return kHubs && face >= graph_.faces.size(); }
  const FloodHub& hub(Index face) const { return graph_.hubs[face - graph_.faces.size()]; }
  std::span<const FloodHubSide> hubSides(Index face) const {
    const Index begin = face == graph_.faces.size() ? 0 : hub(face - 1).sideEnd;
    return std::span(graph_.hubSides).subspan(begin, hub(face).sideEnd - begin);
  }
  std::span<const FloodCorner> hubCorners(Index face) const {
    const Index begin = face == graph_.faces.size() ? 0 : hub(face - 1).cornerEnd;
    return std::span(graph_.hubCorners).subspan(begin, hub(face).cornerEnd - begin);
  }
  template <class Offer>
  void takeHub(Index face, Index chart, float time, const Offer& offer) {
    const Label label = static_cast<Label>(chart);
    words_[face].own = label;
    for (const FloodCorner& c : hubCorners(face)) corners_.take(c.corner, c.times, chart);
    // Nothing else of the chart has been taken yet.
    Index last = kNone;
    for (const FloodHubSide& at : hubSides(face)) {
      words_[at.side >> 2].across[at.side & 3] = label;
      if (at.side >> 2 != last) offer(at.side >> 2, time + at.delay);
      last = at.side >> 2;
    }
  }

  struct Word {
    Label own;
    Label across[3];
  };
  static constexpr Label kFree = std::numeric_limits<Label>::max();
  static constexpr Label kWall = kFree - 1;  ///< beyond a mesh border

  const FloodGraph& graph_;
  RawVector<Word> dry_, words_;
  CornerState corners_;
};

}  // namespace chartflood
