#pragma once
/// The stages of annealing that the seam cuts go through.

#include <cstddef>
#include <vector>

namespace chartflood {

/// One stage of the annealing.
struct SeamStage {
  double weight = 1;       ///< factor on w
  double band = 1;         ///< factor on the width
  std::size_t size = 1;    ///< faces a cluster
  std::size_t sweeps = 5;  ///< over all pairs, at most
};

/// \param clusters begin on clusters of faces; false: single faces throughout
/// \param anneal false: the last stages only, at full weight
std::vector<SeamStage> seamSchedule(std::size_t faces, std::size_t charts, bool clusters,
                                    bool anneal);

}  // namespace chartflood
