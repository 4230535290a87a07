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

std::unique_ptr<Pipeline> Pipeline::sibling(Listener listener) const {
  auto other = std::make_unique<Pipeline>(std::move(listener));
  other->document_ = document_;
  other->logs_ = logs_;
  other->mesh_ = mesh_;
  other->gauss_ = gauss_;
  other->graph_ = graph_;
  other->features_ = features_;
  other->meshVersion_ = meshVersion_;
  other->gaussVersion_ = gaussVersion_;
  other->run_.timing = {run_.timing.read, run_.timing.gaussArea, run_.timing.floodGraph};
  return other;
}

std::unique_ptr<Pipeline> Pipeline::runApart(const Parameters& parameters, const Worth& worth,
                                             Progress& progress) const {
  auto apart = sibling({[](const FloodBegun&) {}, [](const Notice&) {}});
  apart->document_.parameters = parameters;
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
  run.charts = run_.segmentation->chartCount;
  if (run_.stats->balanceDefined) run.spread = run_.stats->stdOverMean();
  run.creases = creaseShare(*mesh_, *gauss_, run_.segmentation->label);
  const double unit = run_.stats->surfaceArea > 0 ? 1 / std::sqrt(run_.stats->surfaceArea) : 0;
  run.seams = run_.stats->seamLength * unit;
  const ChartSet* charts = run_.flat.unwrap ? run_.flat.charts.get() : run_.flat.cut.get();
  for (std::size_t c = 0; charts && c < charts->charts.size(); ++c) {
    for (const Cut& cut : charts->charts[c].cuts) {
      const double length = cut.length * mesh_->scale() * unit;
      run.seams += length;
      if (cut.reason == CutReason::Relief) run.relief += length;
    }
  }
  if (run_.flat.unwrap) measureStretch(*run_.flat.unwrap, *run_.stats, run);
  run.moment = {run_.start, mesh_->faceCount(), true};
  if (!withResults) return run;
  auto results = std::make_shared<Results>();
  report(*results);
  results->record = run_.stepper->record();
  results->recordIteration = run_.stepper->bestIteration();
  results->start = run_.start;
  run.results = std::move(results);
  return run;
}

void Pipeline::takeOver(ChartRun run) {
  setAside();
  const double read = run_.timing.read;
  // Until the new charts are laid flat the old texture is there to look at.
  FlatStages shown = std::move(run_.shownFlat);
  run_ = std::move(run);
  if (!run_.shownFlat.atlas) run_.shownFlat = std::move(shown);
  run_.timing.read = read;
  run_.flat.parameters.rngSeed = document_.parameters.rngSeed;  // of several that were tried
  overtaken_ = false;
  gauss_ = run_.gauss;
  graph_ = run_.graph;
  gaussVersion_ = run_.gaussVersion;
  *run_.onFlood = [this](const FloodBegun& begun) { noteFlood(begun); };
}

void Pipeline::setAside() {
  ChartRun left;
  left.document = run_.document;
  left.depth = run_.depth;
  left.start = run_.start;
  left.segmentation = run_.segmentation;
  left.stats = run_.stats;
  left.flat = run_.flat;
  left.shownFlat = run_.shownFlat;
  left.unwrapAsked = run_.unwrapAsked;
  left.timing = run_.timing;
  kept_.keep(std::exchange(run_, std::move(left)));
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
  takeOver(std::move(pipelines[set->chosen]->run_));
  run_.document = document_;
  tell(Notice::Kind::Info, "Of " + std::to_string(each.size()) + " random seeds, " +
                               std::to_string(each[set->chosen].rngSeed) +
                               " gives the shortest seams among even charts.");
  run_.seedRuns = std::move(set);
  return StepOutcome::Finished;
}

}  // namespace chartflood
