#include "core/charts/tip_cutter.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "core/charts/boundary_cut.h"
#include "core/charts/chart_surface.h"
#include "core/charts/edge_paths.h"

namespace chartflood {

namespace {

struct EdgeLengths {
  double boundary = 0;  ///< of all boundary edges
  double mean = 0;      ///< of an edge, inner ones counted from both sides
};

EdgeLengths edgeLengths(const ChartSurface& surface) {
  EdgeLengths lengths;
  for (Index side = 0; side < surface.opposite.size(); ++side) {
    const double length = sideLength(surface, side);
    lengths.mean += length / static_cast<double>(surface.opposite.size());
    if (surface.opposite[side] == kNone) lengths.boundary += length;
  }
  return lengths;
}

/// Hills of a map of distances, poured together from the top down.
class Hills {
 public:
  explicit Hills(std::size_t vertices) : top_(vertices, kNone) {}

  bool has(Index vertex) const { return top_[vertex] != kNone; }
  void begin(Index vertex) { top_[vertex] = vertex; }
  void join(Index vertex, Index top) { top_[vertex] = top; }
  /// The top of the hill that the vertex belongs to.
  Index topOf(Index vertex) {
    while (top_[vertex] != top_[top_[vertex]]) vertex = top_[vertex] = top_[top_[vertex]];
    return top_[vertex];
  }

 private:
  std::vector<Index> top_;
};

/// Vertices by distance, farthest first, then by number.
std::vector<Index> farthestFirst(const std::vector<double>& distance) {
  std::vector<Index> order;
  for (Index v = 0; v < distance.size(); ++v) {
    if (std::isfinite(distance[v])) order.push_back(v);
  }
  std::stable_sort(order.begin(), order.end(),
                   [&](Index a, Index b) { return distance[a] > distance[b]; });
  return order;
}

/// Local maxima of at least `least`, farthest first; those from which the way to a higher place
/// goes down by less than `depth` are not told apart from it.
std::vector<Index> farMaxima(const ChartSurface& surface, const std::vector<double>& distance,
                             double least, double depth) {
  const std::vector<Index> firstSide = firstSides(surface);
  Hills hills(distance.size());
  std::vector<bool> swallowed(distance.size(), false);
  std::vector<Index> tops;
  const auto higher = [&](Index a, Index b) {
    return distance[a] != distance[b] ? distance[a] > distance[b] : a < b;
  };
  for (const Index v : farthestFirst(distance)) {
    Index top = kNone;
    forEachEdge(surface, firstSide[v], [&](Index, Index end) {
      if (!hills.has(end)) return;
      Index meets = hills.topOf(end);
      if (top == kNone) top = meets;
      if (meets == top) return;
      if (higher(meets, top)) std::swap(meets, top);
      if (distance[meets] - distance[v] < depth) swallowed[meets] = true;
      hills.join(meets, top);
    });
    if (top == kNone) {
      hills.begin(v);
      if (distance[v] >= least) tops.push_back(v);
    } else {
      hills.join(v, top);
    }
  }
  std::erase_if(tops, [&](Index v) { return swallowed[v]; });
  return tops;
}

}  // namespace

void cutTips(CutChart& chart, double tip) {
  const EdgeLengths lengths = edgeLengths(chart.surface);
  const std::vector<double> distance = distanceToBoundary(chart.surface);
  const double least = tip * lengths.boundary;
  for (const Index v : farMaxima(chart.surface, distance, least, lengths.mean)) {
    if (isOnBoundary(chart.surface, v)) continue;  // an earlier cut went by here
    cutToBoundary(chart, v, CutReason::Tip);
  }
}

}  // namespace chartflood
