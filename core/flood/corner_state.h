#pragma once
/// Corners with Gauss area during a flood: a chart gains one when it holds the whole fan.

#include <cstdint>
#include <vector>

#include "core/base/index.h"
#include "core/model/flood_graph.h"

namespace chartflood {

/// Counts taken faces per corner, so that completing a fan is known without walking it.
class CornerState {
 public:
  explicit CornerState(const FloodGraph& graph) : graph_(&graph) { reset(); }

  void reset() {
    left_ = graph_->cornerTimes;
    chart_.assign(left_.size(), kUntouched);
  }
  /// What `chart` gains at `corner` by a face that touches it `times` times.
  double gain(Index corner, Index times, Index chart) const {
    if (left_[corner] != times) return 0;
    const bool alone = chart_[corner] == chart || chart_[corner] == kUntouched;
    return alone ? static_cast<double>(graph_->cornerGain[corner]) : 0;
  }
  void take(Index corner, Index times, Index chart) {
    left_[corner] -= times;
    if (chart_[corner] == kUntouched) {
      chart_[corner] = chart;
    } else if (chart_[corner] != chart) {
      chart_[corner] = kShared;
    }
  }

 private:
  static constexpr Index kUntouched = kNone, kShared = kNone - 1;
  const FloodGraph* graph_;
  std::vector<Index> left_;   ///< times that free faces touch the corner
  std::vector<Index> chart_;  ///< the only chart around so far
};

}  // namespace chartflood
