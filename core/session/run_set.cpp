#include "core/session/run_set.h"

#include <algorithm>
#include <limits>

namespace chartflood {

namespace {

constexpr double kEven = 0.02;
constexpr double kMuchTheSame = 1.25;

}  // namespace

std::size_t shortestBalanced(const std::vector<Run>& runs) {
  // Charts from creases are uneven as the parts of the model are.
  const auto spreadOf = [](const Run& run) {
    return run.moment.creases ? 0 : run.spread.value_or(0);
  };
  double least = std::numeric_limits<double>::infinity();
  for (const Run& run : runs) least = std::min(least, spreadOf(run));
  const double allowed = std::max(kEven, kMuchTheSame * least);
  std::size_t best = RunSet::kNoRun;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (spreadOf(runs[i]) > allowed) continue;
    if (best == RunSet::kNoRun || runs[i].seams < runs[best].seams) best = i;
  }
  return best;
}

std::size_t fewestCharts(const std::vector<Run>& runs, double limit) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < runs.size(); ++i) {
    const bool fits = runs[i].stretch <= limit, bestFits = runs[best].stretch <= limit;
    const bool better = fits != bestFits ? fits
                        : fits           ? runs[i].charts < runs[best].charts
                                         : runs[i].stretch < runs[best].stretch;
    if (better) best = i;
  }
  return best;
}

}  // namespace chartflood
