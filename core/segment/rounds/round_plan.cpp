#include "core/segment/rounds/round_plan.h"

#include <algorithm>
#include <utility>

#include "core/segment/rounds/offsets.h"

namespace chartflood {

RoundPlan::RoundPlan(const SegmentOptions& options, std::size_t maxRounds, std::vector<Index> seeds,
                     std::vector<double> offsets)
    : useOffsets_(options.useOffsets), damping_(options.offsetDamping),
      convergence_({maxRounds, options.patience, options.detectCycles,
                    options.useOffsets && options.offsetDamping > 0, options.settle}),
      seeds_(std::move(seeds)), offsets_(std::move(offsets)) {
  offsets_.resize(seeds_.size(), 0);
}

void RoundPlan::plan(Flood& flood, std::span<const double> chartGauss,
                     std::span<const Index> locked) {
  nextSeeds_ = flood.farthestFromBorder(seeds_);
  for (std::size_t c = 0; c < seeds_.size(); ++c) {
    if (std::binary_search(locked.begin(), locked.end(), seeds_[c])) nextSeeds_[c] = seeds_[c];
  }
  nextOffsets_ = offsets_;
  if (useOffsets_) updateOffsets(nextOffsets_, chartGauss, damping_);
}

void RoundPlan::planMore(std::vector<Index> seeds) {
  nextSeeds_ = std::move(seeds);
  nextOffsets_ = offsets_;
  nextOffsets_.resize(nextSeeds_.size(), 0);
}

StopReason RoundPlan::judge(double badness) {
  const bool settling = convergence_.settling();
  const StopReason stop = convergence_.round(seeds_, nextSeeds_, badness);
  if (newBest()) {
    bestSeeds_ = seeds_;
    offsetsAfterBest_ = nextOffsets_;
  }
  if (settling) {
    nextSeeds_ = seeds_;
  } else if (convergence_.settling()) {
    nextSeeds_ = bestSeeds_;
    nextOffsets_ = offsetsAfterBest_;
  }
  return stop;
}

std::size_t RoundPlan::takeNext() {
  std::size_t moved = 0;
  for (std::size_t c = 0; c < nextSeeds_.size(); ++c) {
    moved += c >= seeds_.size() || seeds_[c] != nextSeeds_[c];
  }
  seeds_ = nextSeeds_;
  offsets_ = nextOffsets_;
  return moved;
}

void RoundPlan::standAt(std::vector<Index> seeds, std::vector<double> offsets) {
  seeds_ = std::move(seeds);
  offsets_ = std::move(offsets);
}

}  // namespace chartflood
