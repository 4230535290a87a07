// Several runs beside each other: how they are made, and the generator seeds that are tried.

#include <algorithm>
#include <atomic>
#include <cmath>
#include <string>
#include <utility>

#include "core/base/parallel.h"
#include "core/charts/chart_stats.h"
#include "core/charts/crease_share.h"
#include "core/session/pipeline/pipeline.h"

namespace chartflood {

namespace {

/// The largest generator seed that the parameter may have.
int largestSeed() { return static_cast<int>(findParameter("rng-seed")->hardMax); }

/// The stretch of charts that are laid flat.
void measureStretch(const Unwrap& unwrap, const ChartStats& stats, Run& run) {
  double squares = 0, surface = 0, worst = 1;
  bool all = true;
  for (std::size_t c = 0; c < unwrap.charts.size(); ++c) {
    const ChartUv& uv = unwrap.charts[c];
    all = all && !uv.uv.empty();
    if (uv.uv.empty()) continue;
    const double area = stats.charts[c].area;
    squares += area * uv.distortion.l2 * uv.distortion.l2;
    surface += area;
    worst = std::max(worst, uv.distortion.l2);
  }
  run.stretch = surface > 0 ? std::sqrt(squares / surface) : 1;
  if (all) run.worst = worst;
}

}  // namespace

std::unique_ptr<Pipeline> Pipeline::runApart(const Parameters& parameters, const Worth& worth,
                                             Progress& progress) const {
  auto apart = std::make_unique<Pipeline>(Listener{[](const FloodBegun&) {}, [](const Notice&) {}});
  apart->document_ = document_;
  apart->document_.parameters = parameters;
  apart->logs_ = logs_;
  apart->mesh_ = mesh_;
  apart->gauss_ = gauss_;
  apart->graph_ = graph_;
  apart->features_ = features_;
  apart->meshVersion_ = meshVersion_;
  apart->gaussVersion_ = gaussVersion_;
  apart->timing_ = {timing_.read, timing_.gaussArea, timing_.floodGraph};
  if (apart->step(StepUnit::Converged, 1, progress) == StepOutcome::Cancelled) return nullptr;
  apart->measure();
  if (worth) {
    if (!worth(apart->asRun(false))) return apart;
    if (!apart->cutOpen(progress)) return nullptr;
    if (!worth(apart->asRun(false))) return apart;
  }
  return apart->layFlat(progress) ? std::move(apart) : nullptr;
}

std::vector<std::unique_ptr<Pipeline>>
Pipeline::runAll(std::span<const Parameters> each, const Worth& worth, Progress& progress) const {
  std::vector<std::unique_ptr<Pipeline>> pipelines(each.size());
  std::atomic<std::size_t> done{0};
  parallelFor(each.size(), [&](std::size_t i) {
    Progress part(&progress);
    pipelines[i] = runApart(each[i], worth, part);
    progress.setFraction(static_cast<float>(++done) / static_cast<float>(each.size()));
  });
  return pipelines;
}

Run Pipeline::asRun(bool withResults) const {
  Run run;
  run.parameters = document_.parameters;
  run.charts = segmentation_->chartCount;
  if (stats_->balanceDefined) run.spread = stats_->stdOverMean();
  run.creases = creaseShare(*mesh_, *gauss_, segmentation_->label);
  const double unit = stats_->surfaceArea > 0 ? 1 / std::sqrt(stats_->surfaceArea) : 0;
  run.seams = stats_->seamLength * unit;
  const ChartSet* charts = flat_.unwrap ? flat_.charts.get() : flat_.cut.get();
  for (std::size_t c = 0; charts && c < charts->charts.size(); ++c) {
    for (const Cut& cut : charts->charts[c].cuts) {
      const double length = cut.length * mesh_->scale() * unit;
      run.seams += length;
      if (cut.reason == CutReason::Relief) run.relief += length;
    }
  }
  if (flat_.unwrap) measureStretch(*flat_.unwrap, *stats_, run);
  run.moment = {start_, mesh_->faceCount(), true};
  if (!withResults) return run;
  auto results = std::make_shared<Results>();
  report(*results);
  results->record = stepper_->record();
  results->recordIteration = stepper_->bestIteration();
  results->start = start_;
  run.results = std::move(results);
  return run;
}

void Pipeline::takeOver(Pipeline& other) {
  stepper_ = std::move(other.stepper_);
  onFlood_ = std::move(other.onFlood_);
  *onFlood_ = [this](const FloodBegun& begun) { noteFlood(begun); };
  segmentation_ = std::move(other.segmentation_);
  stats_ = std::move(other.stats_);
  flat_ = std::move(other.flat_);
  flat_.parameters = document_.parameters;
  timing_ = other.timing_;
  locksChanged_ = false;
  noteFlood({stepper_->record(), stepper_->bestIteration(), std::move(other.start_)});
}

bool Pipeline::triesSeeds() const {
  const Parameters& p = document_.parameters;
  return mesh_ && p.bestOf > 1 && document_.seeds.size() < static_cast<std::size_t>(p.charts);
}

StepOutcome Pipeline::stepWithSeeds(Progress& progress) {
  progress.beginPhase("Trying seeds");
  std::vector<Parameters> each(static_cast<std::size_t>(document_.parameters.bestOf),
                               document_.parameters);
  for (std::size_t i = 0; i < each.size(); ++i) {
    const long seed = long{each[i].rngSeed} + static_cast<long>(i);
    each[i].rngSeed = static_cast<int>(seed % (long{largestSeed()} + 1));
  }
  std::vector<std::unique_ptr<Pipeline>> pipelines = runAll(each, {}, progress);
  if (progress.cancelled()) return StepOutcome::Cancelled;
  auto set = std::make_shared<RunSet>();
  for (const auto& pipeline : pipelines) set->runs.push_back(pipeline->asRun(true));
  set->chosen = shortestBalanced(set->runs);
  takeOver(*pipelines[set->chosen]);
  tell(Notice::Kind::Info, "Of " + std::to_string(each.size()) + " random seeds, " +
                               std::to_string(each[set->chosen].rngSeed) +
                               " gives the shortest seams among even charts.");
  seedRuns_ = std::move(set);
  return StepOutcome::Finished;
}

}  // namespace chartflood
