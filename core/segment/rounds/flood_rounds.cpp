#include "core/segment/rounds/flood_rounds.h"

#include <limits>
#include <utility>

#include "core/base/check.h"
#include "core/gauss/compute_gauss_area.h"
#include "core/segment/parts/chart_areas.h"

namespace chartflood {

namespace {

constexpr std::size_t kAll = std::numeric_limits<std::size_t>::max();

}  // namespace

FloodRounds::FloodRounds(const char* id, const SegmentInputs& inputs, const SegmentOptions& options)
    : id_(id), in_(inputs), options_(options),
      faceGauss_(faceGaussArea(*in_.mesh, *in_.gaussArea)) {}

StepOutcome FloodRounds::advance(StepUnit unit, std::size_t count, Progress& progress) {
  if (finished()) return StepOutcome::Finished;
  switch (unit) {
  case StepUnit::Face:
    return advanceFaces(count, progress);
  case StepUnit::Flood:
    return repeat(count, progress, [&] { return oneFlood(progress); });
  case StepUnit::Iteration:
    return repeat(count, progress, [&] { return oneIteration(progress); });
  case StepUnit::Converged:
    return repeat(kAll, progress, [&] { return oneFlood(progress); });
  }
  return StepOutcome::Advanced;
}

std::shared_ptr<const Segmentation> FloodRounds::state() const {
  FloodStart start = present();
  auto state = std::make_shared<Segmentation>();
  state->method = id_;
  state->chartCount = start.seeds.size();
  state->requestedCharts = options_.charts;
  state->seeds = std::move(start.seeds);
  state->iteration = iteration_;
  if (finished() || phase_ == Phase::Refining) {
    state->label = finalLabel_;
    state->refined = finished() && options_.refine.kind != RefineKind::None;
    state->complete = true;
  } else {
    state->label = labels();
    state->complete = floodDone();
  }
  state->areas = chartAreas(mesh(), *in_.gaussArea, faceGauss_, state->label, state->chartCount);
  return state;
}

StepOutcome FloodRounds::adopt(std::size_t iteration, Progress& progress) {
  CF_CHECK(iteration < history_.size());
  if (!floodAgain(iteration, progress)) return StepOutcome::Cancelled;
  phase_ = Phase::Flooded;
  stopReason_ = StopReason::NotStopped;
  measure();
  planNext();
  return StepOutcome::Advanced;
}

void FloodRounds::restartFlood() {
  record_ = options_.record ? std::make_shared<FloodRecord>(mesh().faceCount()) : nullptr;
  startFlood(record_);
  phase_ = Phase::Flooding;
  stopReason_ = StopReason::NotStopped;
  refiner_.reset();
  if (!options_.onFlood) return;
  options_.onFlood({record_, iteration_, present()});
}

std::shared_ptr<const FloodRecord> FloodRounds::replay(std::size_t iteration, Progress& progress) {
  CF_CHECK(iteration < history_.size());
  progress.beginPhase("Flooding an earlier round again");
  auto record = std::make_shared<FloodRecord>(mesh().faceCount());
  return floodAside(history_[iteration], record, &progress) ? record : nullptr;
}

/// Repeats a step until it is done, cancelled, or everything is finished.
template <class Step>
StepOutcome FloodRounds::repeat(std::size_t count, const Progress& progress, const Step& step) {
  for (std::size_t i = 0; i < count && !finished(); ++i) {
    if (!step() || progress.cancelled()) return StepOutcome::Cancelled;
  }
  return finished() ? StepOutcome::Finished : StepOutcome::Advanced;
}

StepOutcome FloodRounds::advanceFaces(std::size_t count, Progress& progress) {
  while (count > 0 && !finished()) {
    if (!leaveFlooded(progress)) return StepOutcome::Cancelled;
    if (phase_ != Phase::Flooding) break;
    count -= take(count, &progress);
    if (floodDone()) judgeRound();
    if (progress.cancelled()) return StepOutcome::Cancelled;
  }
  return finished() ? StepOutcome::Finished : StepOutcome::Advanced;
}

/// To the end of the flood under way, or of the next one. False when cancelled before.
bool FloodRounds::oneFlood(Progress& progress) {
  if (!leaveFlooded(progress)) return false;
  return finished() || completeFlood(progress);
}

bool FloodRounds::oneIteration(Progress& progress) {
  const bool underWay = phase_ == Phase::Flooding && taken() > 0;
  if (underWay && !completeFlood(progress)) return false;
  return oneFlood(progress);
}

bool FloodRounds::completeFlood(Progress& progress) {
  progress.beginPhase(phaseName());
  take(kAll, &progress);
  if (!floodDone()) return false;
  judgeRound();
  return true;
}

/// After a finished round: begins the next one, or when a stop rule fired, finishes everything.
bool FloodRounds::leaveFlooded(Progress& progress) {
  if (phase_ == Phase::Flooded && stopReason_ == StopReason::NotStopped) {
    const std::optional<std::size_t> moved = takeNext(progress);
    if (!moved) return false;
    movedSeeds_ = *moved;
    iteration_ = history_.size();
    restartFlood();
  }
  return phase_ == Phase::Flooding || finish(progress);
}

/// Measures a finished flood, writes it into the history and plans what comes next.
void FloodRounds::judgeRound() {
  IterationSummary summary = measure();
  FloodStart start = present();
  summary.iteration = iteration_ = history_.size();
  summary.movedSeeds = std::exchange(movedSeeds_, 0);
  summary.seeds = std::move(start.seeds);
  summary.offsets = std::move(start.offsets);
  summary.normals = std::move(start.normals);
  if (start.fast) summary.band = std::move(start.fast->band);
  history_.push_back(std::move(summary));
  const Judgement judgement = judge();
  stopReason_ = judgement.stop;
  phase_ = Phase::Flooded;
  if (!judgement.best) return;
  best_ = iteration_;
  keepBest();
}

/// Adopts the round to be kept and refines its borders.
bool FloodRounds::finish(Progress& progress) {
  if (phase_ == Phase::Flooded) {
    const std::size_t kept = options_.keepLast ? history_.size() - 1 : best_;
    // The log of the present flood must be the one of the labels that are shown.
    const bool again = kept != iteration_ && (record_ || options_.keepLast);
    if (again && !floodAgain(kept, progress)) return false;
    finalLabel_ = options_.keepLast ? labels() : bestLabels();
    standAt(history_[kept]);
    iteration_ = kept;
    phase_ = Phase::Refining;
    rest();
  }
  if (!refiner_) {
    const auto seeds = present().seeds;
    options_.refine.price = price();
    refiner_ = std::make_unique<BorderRefiner>(in_, faceGauss_, finalLabel_, seeds.size(),
                                               std::vector<Index>(seeds.begin(), seeds.end()),
                                               options_.refine);
  }
  if (!refiner_->run(progress)) return false;
  finalLabel_.assign(refiner_->labels().begin(), refiner_->labels().end());
  seamRecord_ = refiner_->record();
  refiner_.reset();
  phase_ = Phase::Done;
  return true;
}

/// Floods round `iteration` of the history again, which gives the same labels. When cancelled, the
/// flood under way is that round's.
bool FloodRounds::floodAgain(std::size_t iteration, Progress& progress) {
  const StopReason reason = stopReason_;
  const Phase phase = phase_;
  standAt(history_[iteration]);
  iteration_ = iteration;
  restartFlood();
  take(kAll, &progress);
  phase_ = phase;
  stopReason_ = reason;
  if (floodDone()) return true;
  iteration_ = history_.size();  // no finished round is shown
  return false;
}

}  // namespace chartflood
