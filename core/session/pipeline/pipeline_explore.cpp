// Values answered with finished charts: a sketch while they change, then what a batch run gives.

#include <utility>
#include <vector>

#include "core/segment/parts/seeds.h"
#include "core/session/pipeline/pipeline.h"

namespace chartflood {

std::vector<Index> Pipeline::seedsAtHand() const {
  const Parameters& now = document_.parameters;
  const Parameters& then = run_.document.parameters;
  // Seeds by hand are values, and those of other rounds or of another draw lead elsewhere.
  const bool follow = run_.segmentation && document_.seeds.empty() && now.method == then.method &&
                      now.rngSeed == then.rngSeed && !run_.start.creases && !wantsCreases();
  if (!follow) return {};
  std::vector<Index> seeds = run_.start.seeds;
  const std::size_t wanted = effectiveChartCount(*mesh_, wantedCharts());
  if (seeds.size() > wanted) seeds.resize(wanted);
  return seeds;
}

bool Pipeline::explore(const Document& document, Depth depth, Progress& progress) {
  const Document before = std::exchange(document_, document);
  if (!mesh_) return false;
  const bool wholeEnough = run_.depth == Depth::Whole || depth == Depth::Sketch;
  if (finished() && !overtaken_ && wholeEnough && sameCharts(run_.document, document)) {
    run_.document = document;
    return false;
  }
  if (std::optional<ChartRun> kept = kept_.take(document)) {
    takeOver(*std::move(kept));
    return true;
  }
  overtaken_ = true;
  makeGround(before.parameters, progress);
  std::vector<Notice> said;
  const std::unique_ptr<Pipeline> apart = sibling(
      {[](const FloodBegun&) {}, [&](Notice notice) { said.push_back(std::move(notice)); }});
  apart->depth_ = depth;
  apart->tellsOutcome_ = false;
  apart->toldCharts_ = toldCharts_;
  apart->toldLiteral_ = toldLiteral_;
  if (depth == Depth::Sketch) {
    apart->run_.start.seeds = seedsAtHand();
    if (logs_ == FloodLogs::EveryRound) apart->logs_ = FloodLogs::LastRound;
  }
  const bool tries = depth == Depth::Whole && apart->triesSeeds();
  const StepOutcome outcome =
      tries ? apart->stepWithSeeds(progress) : apart->step(StepUnit::Converged, 1, progress);
  if (outcome == StepOutcome::Cancelled) return false;
  if (depth == Depth::Whole) {
    toldCharts_ = apart->toldCharts_;
    toldLiteral_ = apart->toldLiteral_;
    for (Notice& notice : said) listener_.onNotice(std::move(notice));
  }
  apart->measure();
  takeOver(std::move(apart->run_));
  return true;
}

}  // namespace chartflood
