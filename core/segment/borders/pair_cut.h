#pragma once
/// The shortest seam between two neighbouring charts within a band around the present one, with
/// Gauss area at a price that keeps the charts equal.

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "core/base/index.h"
#include "core/base/progress.h"
#include "core/segment/borders/max_flow.h"
#include "core/segment/borders/pair_band.h"
#include "core/segment/borders/seam_balance.h"
#include "core/segment/borders/seam_state.h"

namespace chartflood {

/// One pair at a time; storage is kept.
class PairCut {
 public:
  /// Looks for a better seam between charts a and b. Reads the state and writes only scratch
  /// entries of the two charts' nodes. True when one was found that lowers the energy. Once
  /// `progress` is cancelled it gives up, and what it says means nothing.
  bool run(SeamState& state, const SeamBalance& balance, Index a, Index b,
           const Progress& progress);

  /// What the best seam changes.
  double lengthChange() const { return best_.length; }
  const SeamSums& chartA() const { return best_.a; }
  const SeamSums& chartB() const { return best_.b; }
  std::span<const Index> toA() const { return toA_; }  ///< nodes that change chart
  std::span<const Index> toB() const { return toB_; }

 private:
  struct Figures {
    double length = 0;  ///< change of seam length, normalised units
    SeamSums a, b;
    double own = 0;     ///< change of the method's own cost
    double energy = 0;  ///< change
  };
  struct Candidate {
    Figures figures;
    std::vector<std::uint8_t> inA;
  };

  void prepareNodes();
  void buildGraph(double price);
  void setPrice(double price);
  void solve();
  void flip(Index bandNode);
  const Figures& judge();
  bool narrow(const Candidate& low, const Candidate& high);
  void tryPrices(const Progress& progress);
  double lowerBound(double price, double start) const;
  bool choose();
  bool allowed(const Figures& after) const;
  bool staysWhole(std::span<const std::uint8_t> inA);
  std::size_t pieces(std::span<const std::uint8_t> inA, bool ofA);
  bool inPair(Index node) const;
  bool isInA(Index node, std::span<const std::uint8_t> inA) const;
  void release();

  SeamState* state_ = nullptr;
  const SeamBalance* balance_ = nullptr;
  Index a_ = 0, b_ = 0;
  MaxFlow flow_;
  std::vector<Index> band_;                ///< nodes that may change chart
  std::vector<std::uint8_t> start_, inA_;  ///< of each band node
  std::vector<double> owned_;              ///< own cost of each band node in a above that in b
  std::vector<double> priced_;             ///< what of each band node's value is paid for
  std::vector<Index> open_;                ///< band nodes of the present graph
  std::vector<Index> numberInGraph_;       ///< of each band node, kNone for decided ones
  std::vector<MaxFlow::Amount> paid_;      ///< terminal of each node by the present price
  BandHeap heap_;
  std::vector<Index> queue_;
  Figures now_;
  std::vector<Candidate> candidates_;
  std::size_t candidateCount_ = 0;
  Figures best_;
  std::vector<Index> toA_, toB_;
};

}  // namespace chartflood
