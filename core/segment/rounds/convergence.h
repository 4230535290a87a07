#pragma once
/// When the rounds end (paper section 3.4).

#include <cstddef>
#include <set>
#include <span>
#include <vector>

#include "core/base/index.h"
#include "core/model/segmentation.h"

namespace chartflood {

/// The three stop rules: a cycle of seeds, the limit of rounds, no better balance for n rounds.
/// The first is the paper's, which asks for seeds alone. Where offsets change between rounds and
/// may settle, it does not count: the state is more than the seeds then, and resting seeds are what
/// settling begins with.
///
/// Beyond the paper: when moving seeds no longer helps, the rounds may go on from the best one with
/// its seeds at rest, balancing by offsets alone ("settling"), until that does not help either.
class Convergence {
 public:
  struct Rules {
    std::size_t maxIterations = 60;
    std::size_t patience = 10;
    bool detectCycles = true;
    bool offsetsChange = true;
    std::size_t settlePatience = 4;  ///< rounds without gain that end settling; 0: do not settle
  };
  explicit Convergence(const Rules& rules) : rules_(rules) {}

  /// Tells of a finished round flooded from `seeds` with the given badness (smaller is better) and
  /// the seeds wanted next; says whether to stop and why.
  StopReason round(std::span<const Index> seeds, std::span<const Index> nextSeeds, double badness);

  std::size_t best() const { return best_; }  ///< number of the best round so far
  std::size_t rounds() const { return rounds_; }
  bool settling() const { return settling_; }

 private:
  Rules rules_;
  std::set<std::vector<Index>> seen_;
  std::size_t rounds_ = 0, best_ = 0;
  std::size_t lastGain_ = 0;  ///< best round, or the one after which settling began
  bool settling_ = false;
  double bestBadness_ = 0;
};

}  // namespace chartflood
