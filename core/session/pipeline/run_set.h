#pragma once
/// Several runs beside each other, of which one was chosen: other generator seeds, or other numbers
/// of charts.

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "core/session/pipeline/document.h"

namespace chartflood {

struct Results;

/// One run and what came out.
struct Run {
  Parameters parameters;         ///< that it was made with
  std::size_t charts = 0;        ///< that it has
  std::optional<double> spread;  ///< standard deviation over mean of Gauss area
  double seams = 0;              ///< borders and cuts over the root of the area
  double relief = 0;             ///< the part of relief cuts in that
  double creases = 0;            ///< share of the length of sharp edges that lies on borders
  /// L2 of the whole surface: root of the area-weighted mean square. Absent where the charts were
  /// not laid flat, their seams being too long as they are.
  std::optional<double> stretch;
  std::optional<double> worst;  ///< L2 of the worst chart; absent where not all are laid flat

  /// True when no chart stretches more.
  bool keeps(double limit) const { return worst && *worst <= limit; }
  FloodMoment moment;                      ///< from which its charts can be made again
  std::shared_ptr<const Results> results;  ///< not laid flat; null when they were not kept
};

/// Ascending in what differs.
struct RunSet {
  static constexpr std::size_t kNoRun = static_cast<std::size_t>(-1);
  std::vector<Run> runs;
  std::size_t chosen = kNoRun;
};

/// Which run has the shortest seams among those whose charts are as even as they can be: spread up
/// to 2 %, or up to a quarter more than the least where none is that even. Charts from creases
/// count as even. \pre there is a run
std::size_t shortestBalanced(const std::vector<Run>& runs);

/// Which run has the shortest seams among those that keep the limit in every chart; of these those
/// come first whose borders hold at least `creases` of the length of sharp edges. Where none keeps
/// it, the one with the least worst chart. \pre there is a run that was laid flat
std::size_t shortestWithin(const std::vector<Run>& runs, double limit, double creases = 0);

}  // namespace chartflood
