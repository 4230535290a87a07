#include "core/segment/rounds/convergence.h"

#include <algorithm>

namespace chartflood {

StopReason Convergence::round(std::span<const Index> seeds, std::span<const Index> nextSeeds,
                              double badness) {
  const std::size_t number = rounds_++;
  if (number == 0 || badness < bestBadness_) {
    best_ = lastGain_ = number;
    bestBadness_ = badness;
  }
  const bool seedsTell = !rules_.offsetsChange || rules_.settlePatience == 0;
  if (seedsTell && rules_.detectCycles) {
    if (std::equal(seeds.begin(), seeds.end(), nextSeeds.begin(), nextSeeds.end())) {
      return StopReason::Converged;
    }
    std::vector<Index> set(seeds.begin(), seeds.end());
    std::sort(set.begin(), set.end());
    seen_.insert(std::move(set));
    std::vector<Index> next(nextSeeds.begin(), nextSeeds.end());
    std::sort(next.begin(), next.end());
    if (seen_.contains(next)) return StopReason::Cycle;
  }
  if (rounds_ >= rules_.maxIterations) return StopReason::MaxIterations;
  if (number - lastGain_ < (settling_ ? rules_.settlePatience : rules_.patience)) {
    return StopReason::NotStopped;
  }
  if (settling_ || !rules_.offsetsChange || rules_.settlePatience == 0) {
    return StopReason::NoImprovement;
  }
  settling_ = true;
  lastGain_ = number;
  return StopReason::NotStopped;
}

}  // namespace chartflood
