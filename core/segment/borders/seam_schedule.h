#pragma once
/// The stages of annealing that the seam cuts go through.

#include <cstddef>
#include <vector>

namespace chartflood {

/// One stage of the annealing.
struct SeamStage {
  double weight = 1;       ///< of balance, or factor on it
  double band = 1;         ///< factor on the width
  std::size_t size = 1;    ///< faces a cluster
  std::size_t sweeps = 5;  ///< over all pairs, at most
};

/// From little to full weight, weights as factors.
/// \param clusters begin on clusters of faces; false: single faces throughout
/// \param anneal false: the last stages only, at full weight
std::vector<SeamStage> seamSchedule(std::size_t faces, std::size_t charts, bool clusters,
                                    bool anneal);

/// A short way, for a look while values are dragged; weights as factors.
std::vector<SeamStage> seamSketch(std::size_t faces, std::size_t charts, bool anneal);

/// The same way for every weight w, to 1000, then on to w in steps of ten: downwards seams only
/// get shorter, upwards charts only more even, so that the seams of a larger w are not shorter.
/// Each weight with a way of its own ends in another place, by up to 3 % of length either way.
std::vector<SeamStage> seamScheduleTo(double weight, std::size_t faces, std::size_t charts,
                                      bool clusters);

}  // namespace chartflood
