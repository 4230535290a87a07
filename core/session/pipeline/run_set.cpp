#include "core/session/pipeline/run_set.h"

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
    return run.moment.start.creases ? 0 : run.spread.value_or(0);
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

std::size_t shortestWithin(const std::vector<Run>& runs, double limit, double creases) {
  const auto worst = [](const Run& run) {
    return run.worst.value_or(std::numeric_limits<double>::infinity());
  };
  const auto before = [&](const Run& a, const Run& b) {
    if (a.keeps(limit) != b.keeps(limit)) return a.keeps(limit);
    if (!a.keeps(limit)) return worst(a) < worst(b);
    const bool enough = a.creases >= creases;
    return enough != (b.creases >= creases) ? enough : a.seams < b.seams;
  };
  return static_cast<std::size_t>(std::min_element(runs.begin(), runs.end(), before) -
                                  runs.begin());
}

}  // namespace chartflood
