#pragma once
/// Finished runs of other values, kept so that undo, redo and a slider's way back find theirs
/// without computing.

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "core/session/pipeline/chart_run.h"

namespace chartflood {

/// The newest runs of one mesh, as many as fit in bounded memory: the oldest are dropped first.
class KeptRuns {
 public:
  static constexpr std::size_t kMostBytes = std::size_t{256} << 20;

  KeptRuns() : KeptRuns(kMostBytes) {}
  explicit KeptRuns(std::size_t mostBytes) : mostBytes_(mostBytes) {}

  void clear();
  /// Keeps a run that is finished and whole, in place of an older one of the same charts; others
  /// are dropped.
  void keep(ChartRun run);
  /// Hands out the run of these charts; with a moment, only where they came from there.
  std::optional<ChartRun> take(const Document& document, const FloodMoment* moment = nullptr);

  std::size_t size() const { return runs_.size(); }
  /// About what the kept runs occupy.
  std::size_t bytes() const { return bytes_; }

 private:
  struct Kept {
    std::unique_ptr<ChartRun> run;
    std::size_t bytes = 0;
  };
  void drop(std::size_t place);

  std::size_t mostBytes_;
  std::size_t bytes_ = 0;
  std::vector<Kept> runs_;  ///< oldest first
};

}  // namespace chartflood
