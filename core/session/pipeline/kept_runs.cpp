#include "core/session/pipeline/kept_runs.h"

#include <algorithm>
#include <utility>

namespace chartflood {

namespace {

/// What a stepper at rest, labels, cut surfaces and places in the plane take for each face, about:
/// measured on meshes of 20,000 to a million triangles.
constexpr std::size_t kBytesPerFace = 320;

std::size_t bytesOf(const ChartRun& run) {
  const std::size_t faces = run.segmentation ? run.segmentation->label.size() : 0;
  return run.floods.bytes() + kBytesPerFace * faces;
}

}  // namespace

void KeptRuns::clear() {
  runs_.clear();
  bytes_ = 0;
}

void KeptRuns::drop(std::size_t place) {
  bytes_ -= runs_[place].bytes;
  runs_.erase(runs_.begin() + static_cast<std::ptrdiff_t>(place));
}

void KeptRuns::keep(ChartRun run) {
  if (!run.finished() || run.depth != Depth::Whole || !run.segmentation) return;
  const FloodMoment moment = run.moment();
  for (std::size_t i = runs_.size(); i-- > 0;) {
    const ChartRun& old = *runs_[i].run;
    if (sameCharts(old.document, run.document) && old.moment() == moment) drop(i);
  }
  Kept kept;
  kept.bytes = bytesOf(run);
  kept.run = std::make_unique<ChartRun>(std::move(run));
  bytes_ += kept.bytes;
  runs_.push_back(std::move(kept));
  while (bytes_ > mostBytes_ && !runs_.empty()) drop(0);
}

std::optional<ChartRun> KeptRuns::take(const Document& document, const FloodMoment* moment) {
  for (std::size_t i = runs_.size(); i-- > 0;) {
    const ChartRun& run = *runs_[i].run;
    if (!sameCharts(run.document, document)) continue;
    if (moment != nullptr && run.moment() != *moment) continue;
    std::optional<ChartRun> found = std::move(*runs_[i].run);
    drop(i);
    return found;
  }
  return std::nullopt;
}

}  // namespace chartflood
