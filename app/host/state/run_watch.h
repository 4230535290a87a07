#pragma once
/// What the viewer does with runs that the session has tried beside each other.

#include <memory>

#include "core/session/pipeline/run_set.h"

namespace chartflood {

class AppState;

/// The sets of runs that were seen last.
struct RunWatch {
  std::shared_ptr<const RunSet> seedRuns, chartRuns;

  /// Takes in new sets: the other seeds are kept for comparison where slots are free, and the
  /// number of charts that was looked for is used, as a step that can be undone.
  void update(AppState& state);
};

/// Makes the charts of a tried number the present ones: the very same where the other parameters
/// are as they were then, else new ones. \pre results().chartRuns has that run
void useChartRun(AppState& state, std::size_t run);

}  // namespace chartflood
