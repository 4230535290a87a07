// Several runs beside each other: generator seeds that are tried, and numbers of charts.

#include <atomic>
#include <cmath>
#include <string>
#include <utility>

#include "core/base/parallel.h"
#include "core/charts/chart_stats.h"
#include "core/session/pipeline.h"

namespace chartflood {

namespace {

constexpr int kMostRunCharts = 512;

/// The largest generator seed that the parameter may have.
int largestSeed() { return static_cast<int>(findParameter("rng-seed")->hardMax); }

/// Numbers of charts that are tried together, in this order; the batches are the same for any
/// number of threads.
std::vector<std::vector<int>> ladder(int least, int most) {
  std::vector<std::vector<int>> batches = {{1, 2, 3, 4}};
  for (int k = 6; k <= kMostRunCharts; k *= 4) batches.push_back({k, k * 4 / 3, 2 * k, k * 8 / 3});
  for (std::vector<int>& batch : batches) {
    std::erase_if(batch, [&](int k) { return k < least || k > most; });
  }
  std::erase_if(batches, [](const std::vector<int>& batch) { return batch.empty(); });
  if (batches.empty()) batches = {{std::min(least, most)}};
  return batches;
}

}  // namespace

std::unique_ptr<Pipeline> Pipeline::runApart(const Parameters& parameters,
                                             Progress& progress) const {
  auto apart = std::make_unique<Pipeline>(Listener{[](const FloodStart&) {}, [](const Notice&) {}});
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
  return apart->layFlat(progress) ? std::move(apart) : nullptr;
}

std::vector<std::unique_ptr<Pipeline>> Pipeline::runAll(std::span<const Parameters> each,
                                                        Progress& progress) const {
  std::vector<std::unique_ptr<Pipeline>> pipelines(each.size());
  std::atomic<std::size_t> done{0};
  parallelFor(each.size(), [&](std::size_t i) {
    Progress part(&progress);
    pipelines[i] = runApart(each[i], part);
    progress.setFraction(static_cast<float>(++done) / static_cast<float>(each.size()));
  });
  return pipelines;
}

Run Pipeline::asRun(bool withResults) const {
  Run run;
  run.parameters = document_.parameters;
  run.charts = segmentation_->chartCount;
  if (stats_->balanceDefined) run.spread = stats_->stdOverMean();
  double length = stats_->seamLength, squares = 0, surface = 0;
  for (std::size_t c = 0; c < flat_.charts->charts.size(); ++c) {
    length += flat_.charts->charts[c].cutLength() * mesh_->scale();
    const ChartUv& uv = flat_.unwrap->charts[c];
    if (uv.uv.empty()) continue;
    const double area = stats_->charts[c].area;
    squares += area * uv.distortion.l2 * uv.distortion.l2;
    surface += area;
    run.worst = std::max(run.worst, uv.distortion.l2);
  }
  run.seams = stats_->surfaceArea > 0 ? length / std::sqrt(stats_->surfaceArea) : 0;
  run.stretch = surface > 0 ? std::sqrt(squares / surface) : 1;
  run.moment = {seeds_, offsets_, mesh_->faceCount(), true, normals_, creases_, fast_};
  if (!withResults) return run;
  auto results = std::make_shared<Results>();
  report(*results);
  results->record = stepper_->record();
  results->recordIteration = stepper_->bestIteration();
  results->seeds = seeds_;
  results->offsets = offsets_;
  results->normals = normals_;
  results->creases = creases_;
  results->fast = fast_;
  run.results = std::move(results);
  return run;
}

void Pipeline::takeOver(Pipeline& other) {
  stepper_ = std::move(other.stepper_);
  onFlood_ = std::move(other.onFlood_);
  *onFlood_ = [this](const FloodStart& start) { noteFlood(start); };
  segmentation_ = std::move(other.segmentation_);
  stats_ = std::move(other.stats_);
  flat_ = std::move(other.flat_);
  flat_.parameters = document_.parameters;
  timing_ = other.timing_;
  creases_ = other.creases_;
  const std::optional<FastFlood> fast = std::move(other.fast_);
  locksChanged_ = false;
  const std::vector<Index> seeds = std::move(other.seeds_);
  const std::vector<double> offsets = std::move(other.offsets_);
  const std::vector<glm::dvec3> normals = std::move(other.normals_);
  noteFlood(
      {stepper_->record(), stepper_->bestIteration(), seeds, offsets, normals, creases_, fast});
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
  std::vector<std::unique_ptr<Pipeline>> pipelines = runAll(each, progress);
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

bool Pipeline::findChartCount(Progress& progress) {
  const double limit = document_.parameters.maxStretch;
  auto set = std::make_shared<RunSet>();
  const auto tryAll = [&](const std::vector<int>& counts) {
    progress.beginPhase("Trying numbers of charts");
    std::vector<Parameters> each(counts.size(), document_.parameters);
    for (std::size_t i = 0; i < counts.size(); ++i) each[i].charts = counts[i];
    const std::vector<std::unique_ptr<Pipeline>> pipelines = runAll(each, progress);
    if (progress.cancelled()) return false;
    for (const auto& pipeline : pipelines) set->runs.push_back(pipeline->asRun(false));
    std::stable_sort(set->runs.begin(), set->runs.end(),
                     [](const Run& a, const Run& b) { return a.charts < b.charts; });
    set->chosen = fewestCharts(set->runs, limit);
    return true;
  };
  const auto fits = [&] { return set->runs[set->chosen].stretch <= limit; };
  const int most = static_cast<int>(std::min<std::size_t>(mesh_->faceCount(), kMostRunCharts));
  for (const auto& batch : ladder(static_cast<int>(mesh_->componentCount()), most)) {
    if (!tryAll(batch)) return false;
    if (fits()) break;
  }
  // Between the first number that fits and the one before it, three at a time.
  while (fits() && set->chosen > 0) {
    const int low = static_cast<int>(set->runs[set->chosen - 1].charts);
    const int gap = static_cast<int>(set->runs[set->chosen].charts) - low;
    std::vector<int> between;
    for (int i = 1; i <= 3; ++i) {
      const int k = low + (gap * i) / 4;
      if (k > low && k < low + gap && (between.empty() || between.back() != k)) {
        between.push_back(k);
      }
    }
    if (between.empty()) break;
    if (!tryAll(between)) return false;
  }
  const Run& run = set->runs[set->chosen];
  if (!fits()) {
    tell(Notice::Kind::Warning,
         "No number of charts that was tried stretches as little as asked; " +
             std::to_string(run.charts) + " stretch least.");
  }
  chartRuns_ = std::move(set);
  return true;
}

}  // namespace chartflood
