#pragma once
/// Border clean-up: single faces change sides while that shortens seams or evens out Gauss area.
/// Beyond the paper, whose floods leave borders in stairs.

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/base/progress.h"
#include "core/model/gauss_area.h"
#include "core/model/mesh.h"
#include "core/segment/parts/chart_price.h"

namespace chartflood {

/// Lowers the energy
///
///   sum over seam edges of length * (crease line ? 0.3 : 1) / unit
///     + W * mean_i ((B_i - mean) / mean)^2,   B_i = A(i) + eta * area(i),
///
/// as a clean-up: the unit is the mean edge length and W = 400 mu sqrt(F / 70000); or as the seam
/// cuts do: the unit is sqrt(area) and W their w. In both the price does not grow with the number
/// of charts: where it does, many charts have their borders shattered for a little more balance.
///
/// A face moves from chart a to chart b when its sides form one run against a and one against b,
/// all other faces around every vertex inside a run belong to that run's chart, and these vertices
/// are interior: such moves keep the Euler number and the number of loops of both charts, and never
/// empty one. Seed faces stay. Faces are tried in ascending order until a sweep moves none.
class BorderMoves {
 public:
  struct Options {
    double weight = 1000;       ///< how much balance counts against short seams: mu, or w
    bool likeCuts = false;      ///< the energy of SeamCuts, its w
    double creaseFactor = 0.3;  ///< length of a crease line against other edges'
    double eta = 0;             ///< steradians a squared normalised unit of surface counts as
    std::span<const double> sideFactor = {};  ///< of hints, on the length of each side; empty: 1
    const ChartPrice* price = nullptr;        ///< the method's own cost, added to the energy
    /// What all seams together may grow by, as a share of their length at first; below 0: anything.
    double mostLonger = -1;
    std::size_t maxSweeps = 50;
  };

  /// \param seeds faces that stay where they are
  BorderMoves(const Mesh& mesh, const GaussArea& gauss, std::span<const double> faceGauss,
              std::vector<Index> label, std::size_t charts, std::span<const Index> seeds,
              const Options& options);
  ~BorderMoves();

  /// Sweeps until nothing moves or `progress` is cancelled; true when nothing is left to move.
  /// A cancelled run goes on where it stopped.
  bool run(Progress& progress);

  std::span<const Index> labels() const { return label_; }
  std::size_t moves() const { return moves_; }
  /// First part of the energy, of the present labels.
  double seamLength() const;
  /// Standard deviation of the charts' B over their mean; 0 where they have none.
  double deviation() const;
  /// The energy above without the method's own cost, for tests.
  double energy() const { return seamLength() + balanceEnergy(sum_, squares_); }

 private:
  struct Tables;
  struct Move;

  void findBorders();
  bool findMove(Index face, Move& move);
  double balanceEnergy(double sum, double squares) const;
  void apply(Index face, const Move& move);
  void activate(Index face) { active_[face / 64] |= std::uint64_t{1} << (face % 64); }

  const Mesh& mesh_;
  std::unique_ptr<const Tables> tables_;
  std::vector<Index> label_;
  std::vector<bool> fixed_;
  std::vector<double> value_;           ///< B of each chart
  double sum_ = 0, squares_ = 0;        ///< of value_, of charts with a neighbour
  std::size_t evened_ = 0;              ///< how many those are
  double weight_ = 0;                   ///< W over the number of charts
  double longer_ = 0, mostLonger_ = 0;  ///< growth of the seams so far, and at most
  std::size_t sweepsLeft_ = 0;
  std::size_t moves_ = 0;
  std::size_t position_ = 0;  ///< next face of the sweep under way
  std::size_t movedInSweep_ = 0;
  std::vector<std::uint64_t> active_;  ///< faces at chart borders, one bit each
  std::vector<Index> sides_;           ///< of the face under test
};

}  // namespace chartflood
