#pragma once
/// One pass of minimum cuts over the neighbouring pairs of charts, on all threads.

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "core/base/index.h"
#include "core/base/progress.h"
#include "core/segment/borders/pair_cut.h"
#include "core/segment/borders/seam_balance.h"
#include "core/segment/borders/seam_state.h"

namespace chartflood {

/// Storage is kept from one pass to the next.
class SeamSweep {
 public:
  /// What the cut of one pair moved.
  struct Step {
    Index a = 0, b = 0;           ///< charts
    std::vector<Index> toB, toA;  ///< nodes; both empty: nothing
  };

  /// Lines up the pairs of which one chart is marked in `changed`, in rounds of pairs without a
  /// common chart.
  void begin(const SeamState& state, const SeamBalance& balance,
             std::span<const std::uint8_t> changed);
  /// Cuts the pairs and applies what lowers the energy. False when it was stopped: all pairs are
  /// cut or as they were then, and going on gives what going straight through would have given.
  bool run(SeamState& state, const Progress& progress);
  /// Of each pair, in order. Whole once run() returned true.
  std::span<const Step> steps() const { return steps_; }

 private:
  struct Worker {
    PairCut cut;
    std::vector<Index> merged;
  };

  bool cutPair(SeamState& state, Worker& worker, std::size_t pair, const Progress& progress);
  SeamBalance balanceFor(const SeamState& state, Index a, Index b) const;

  SeamBalance balance_;         ///< at the beginning of the pass
  std::vector<double> values_;  ///< of the charts then
  std::vector<std::pair<Index, Index>> pairs_, waiting_;
  std::vector<std::uint8_t> done_;  ///< of each pair
  std::vector<Step> steps_;
  std::vector<Worker> workers_;
};

}  // namespace chartflood
