#pragma once
/// Shortest paths along the edges of a chart that may be cut. The cutters are made of these.

#include <limits>
#include <utility>
#include <vector>

#include "core/charts/chart_surface.h"

namespace chartflood {

inline constexpr double kNoWay = std::numeric_limits<double>::infinity();

/// One side that starts at each vertex, the first one counter-clockwise on the boundary, so that
/// turning from it visits the whole fan.
std::vector<Index> firstSides(const ChartSurface& surface);

/// Calls `visit(side, end)` for every edge at a vertex that is no diagonal, counter-clockwise;
/// `side` is one of the edge's two. The last edge of a boundary vertex is met from its other end.
/// \param first the vertex's entry of firstSides()
template <class Visit>
void forEachEdge(const ChartSurface& surface, Index first, Visit visit) {
  Index side = first;
  do {
    if (!surface.isDiagonal(side)) visit(side, surface.sideEnd(side));
    const Index back = ChartSurface::previousSide(side);
    side = surface.opposite[back];
    if (side == kNone) {
      visit(back, surface.sideStart(back));
      return;
    }
  } while (side != first);
}

/// Vertices by distance, nearest first, then by number.
class VertexQueue {
 public:
  struct Entry {
    double distance;
    Index vertex;
    bool operator<(const Entry& other) const {
      return distance != other.distance ? distance < other.distance : vertex < other.vertex;
    }
  };

  bool empty() const { return entries_.empty(); }
  const Entry& top() const { return entries_.front(); }
  void clear() { entries_.clear(); }
  void push(double distance, Index vertex);
  Entry pop();

 private:
  std::vector<Entry> entries_;
};

/// Distances from a growing set of sources, found nearest first. The surface must not change while
/// it is in use.
class EdgeDistances {
 public:
  explicit EdgeDistances(const ChartSurface& surface);

  /// Makes the vertex a source; may be called between two calls of next().
  void addSource(Index vertex);
  /// The nearest vertex that was not handed out since it was last brought nearer; kNone when there
  /// is none left.
  Index next();
  /// To the nearest source; infinite where there is no way.
  double distance(Index vertex) const { return distance_[vertex]; }
  const std::vector<double>& distances() const { return distance_; }
  /// The sides of the path from the nearest source to the vertex, in order and pointing away from
  /// the source.
  std::vector<Index> pathTo(Index vertex) const;

  /// No path may run along an edge between these two vertices.
  void forbid(Index a, Index b) { forbidden_ = {a, b}; }

 private:
  const ChartSurface& surface_;
  std::vector<Index> firstSide_;
  std::vector<double> distance_;
  std::vector<Index> side_;  ///< that leads to each vertex, kNone at a source
  VertexQueue queue_;
  std::pair<Index, Index> forbidden_{kNone, kNone};
};

}  // namespace chartflood
