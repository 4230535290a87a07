#pragma once
/// Offsets between charts whose floods always begin in the same places, where the rule of paper
/// section 3.5 creeps: what is left over falls by a sixth a round.

#include <span>
#include <vector>

namespace chartflood {

/// Moves each chart's offset by its surplus of Gauss area times a step of its own, which grows
/// while the surplus keeps its sign and shrinks when that turns (the rule of resilient propagation:
/// Riedmiller and Braun, 1993).
class OffsetSteps {
 public:
  /// Rounds begin anew.
  void reset() { steps_.clear(); }
  /// Offsets of the next round, the smallest 0. \param chartGauss A(c) of the charts that `offsets`
  /// led to, steradians
  void update(std::vector<double>& offsets, std::span<const double> chartGauss);

 private:
  struct Step {
    double share;
    double surplus = 0;  ///< of the round before
  };
  std::vector<Step> steps_;
};

}  // namespace chartflood
