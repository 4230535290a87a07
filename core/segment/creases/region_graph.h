#pragma once
/// Regions of a surface that are joined pair by pair, as in a drawing where lines are rubbed out.

#include <cstddef>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "core/base/index.h"
#include "core/model/mesh.h"

namespace chartflood {

class RegionGraph {
 public:
  RegionGraph(const Mesh& mesh, std::span<const Index> label, std::size_t regions);

  std::size_t count() const { return count_; }
  /// Joins the pair of neighbours with the greatest
  ///
  ///   common length / sqrt(area) - 4 * smaller share of the area
  ///     - 0.4 * growth of max(0, 1 - Euler number) - 0.3 * mean bend of the border (radians);
  ///
  /// false when no two regions touch.
  bool joinBest();
  /// The same among the pairs of which one is a single triangle; false when there is none.
  bool joinLone();
  /// Where a region of the beginning is now.
  Index regionNow(Index region) const { return into_[region]; }

 private:
  struct Border {
    double length = 0;
    double bend = 0;  ///< sum of length times angle
    int euler = 0;    ///< what the Euler number gains when it goes, corners left out
    int corners = 0;  ///< corners where just these two regions meet
  };
  bool join(bool loneOnly);
  double score(Index a, Index b, const Border& border) const;
  int eulerOfBoth(Index a, Index b, const Border& border) const;
  void join(Index a, Index b);
  void countCorners();

  double surface_;
  std::size_t count_;
  std::vector<Index> into_;
  std::vector<double> area_;
  std::vector<int> euler_;
  std::vector<Index> triangles_;
  std::map<std::pair<Index, Index>, Border> borders_;  ///< smaller number first
  std::vector<std::vector<Index>> corners_;            ///< regions at vertices with three or more
};

}  // namespace chartflood
