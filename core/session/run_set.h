#pragma once
/// Several runs beside each other, of which one was chosen: other generator seeds, or other numbers
/// of charts.

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "core/session/document.h"

namespace chartflood {

struct Results;

/// One run and what came out.
struct Run {
  Parameters parameters;         ///< that it was made with
  std::size_t charts = 0;        ///< that it has
  std::optional<double> spread;  ///< standard deviation over mean of Gauss area
  double seams = 0;              ///< borders and cuts over the root of the area
  double stretch = 0;            ///< L2 of the whole surface: root of the area-weighted mean square
  double worst = 0;              ///< L2 of the worst chart
  FloodMoment moment;            ///< from which its charts can be made again
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

/// Which run has the fewest charts with a stretch of at most `limit`; where none has, the one with
/// the least stretch. \pre there is a run
std::size_t fewestCharts(const std::vector<Run>& runs, double limit);

}  // namespace chartflood
