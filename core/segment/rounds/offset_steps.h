#pragma once
/// Offsets between charts whose floods always begin in the same places, where the rule of paper
/// section 3.5 creeps: what is left over falls by a sixth a round.

#include <span>
#include <vector>

namespace chartflood {

/// Moves the offsets by a share of the surplus of Gauss area, after the part of it is taken away
/// that earlier rounds tell how to remove: what their changes of the offsets did to the surplus is
/// taken to be linear (the mixing of Anderson, 1965).
class OffsetSteps {
 public:
  /// Rounds begin anew.
  void reset() { rounds_.clear(); }
  /// Offsets of the next round, the smallest 0. \param chartGauss A(c) of the charts that `offsets`
  /// led to, steradians
  void update(std::vector<double>& offsets, std::span<const double> chartGauss);

 private:
  /// Both add up to 0: floods do not depend on what all offsets have in common.
  struct Round {
    std::vector<double> offsets, surplus;
  };
  std::vector<Round> rounds_;  ///< the newest last
};

}  // namespace chartflood
