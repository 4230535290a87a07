#pragma once
/// Charts over the nodes of a level while their seams move.

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/base/index.h"
#include "core/segment/borders/seam_level.h"
#include "core/segment/parts/chart_price.h"

namespace chartflood {

/// Sums over a chart.
struct SeamSums {
  double value = 0;  ///< B: Gauss area plus eta times area, steradians
  double area = 0;   ///< squared normalised units
  int euler = 0;
};

/// What is known of a chart while seams move.
struct SeamChart : SeamSums {
  std::vector<Index> nodes;  ///< ascending
};

/// Charts over the nodes of a level. The scratch arrays have one entry a node (arc); pairs without
/// a common chart use different entries, so that they may be cut at the same time.
struct SeamState {
  const SeamLevel* level = nullptr;
  std::vector<Index> label;  ///< chart of each node
  std::vector<SeamChart> charts;
  std::vector<Index> local, localArc;  ///< number in the pair's band
  std::vector<double> distance;        ///< from the pair's seam
  std::vector<std::uint8_t> seen;
  double band = 0;                    ///< width, normalised units
  double unit = 1;                    ///< energy of a normalised unit of length
  double leastArea = 0;               ///< charts are not made smaller than this
  double defect = 0;                  ///< energy that a chart gains by getting nearer to a disk
  const ChartPrice* price = nullptr;  ///< the method's own cost of faces
  double leastGain = 0;               ///< of energy, below which a cut is not looked for
};

/// The chart of a node that another thread may move between two other charts meanwhile.
inline Index labelOf(SeamState& state, Index node) {
  return std::atomic_ref(state.label[node]).load(std::memory_order_relaxed);
}
inline void setLabel(SeamState& state, Index node, Index chart) {
  std::atomic_ref(state.label[node]).store(chart, std::memory_order_relaxed);
}

/// Sums of every chart from its nodes. \pre label and level are set
void measureSeamCharts(SeamState& state, std::size_t charts);

}  // namespace chartflood
