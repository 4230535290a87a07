#pragma once
/// What each round of t-flooding begins with: the seeds and offsets that follow from the round
/// before (paper sections 3.4 and 3.5), and when to stop.

#include <cstddef>
#include <span>
#include <vector>

#include "core/base/index.h"
#include "core/flood/flood.h"
#include "core/segment/parts/segmenter.h"
#include "core/segment/rounds/convergence.h"

namespace chartflood {

/// Over the faces of a mesh or the nodes of a graph of clusters alike.
class RoundPlan {
 public:
  RoundPlan() : convergence_(Convergence::Rules{}) {}
  /// \param offsets one a seed; missing ones are 0
  RoundPlan(const SegmentOptions& options, std::size_t maxRounds, std::vector<Index> seeds,
            std::vector<double> offsets);

  /// Of the flood at hand.
  const std::vector<Index>& seeds() const { return seeds_; }
  const std::vector<double>& offsets() const { return offsets_; }

  /// Plans what follows the finished flood, as if no rule had stopped.
  /// \param chartGauss A(c) of its charts
  /// \param locked seeds that stay, ascending
  void plan(Flood& flood, std::span<const double> chartGauss, std::span<const Index> locked);
  /// After plan(): the next round begins with more seeds, and with the offsets of this one: they
  /// change only once all seeds are there (section 3.4).
  void planMore(std::vector<Index> seeds);
  /// The seeds of the next round.
  const std::vector<Index>& nextSeeds() const { return nextSeeds_; }
  /// Judges a new round, after plan(): why to stop, if so. Settling seeds are put to rest.
  StopReason judge(double badness);
  /// The round that judge() was told of last is the best so far.
  bool newBest() const { return convergence_.best() + 1 == convergence_.rounds(); }
  /// What was planned becomes present; returns how many seeds are elsewhere.
  std::size_t takeNext();
  /// Other seeds and offsets become present.
  void standAt(std::vector<Index> seeds, std::vector<double> offsets);

 private:
  bool useOffsets_ = true;
  double damping_ = 0;
  Convergence convergence_;
  std::vector<Index> seeds_, nextSeeds_, bestSeeds_;
  std::vector<double> offsets_, nextOffsets_, offsetsAfterBest_;
};

}  // namespace chartflood
