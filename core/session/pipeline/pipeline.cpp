#include "core/session/pipeline/pipeline.h"

#include <algorithm>
#include <utility>

#include "core/base/stopwatch.h"
#include "core/charts/chart_stats.h"
#include "core/flood/build_flood_graph.h"
#include "core/gauss/compute_gauss_area.h"
#include "core/model/build_mesh.h"
#include "core/segment/creases/flat_regions.h"
#include "core/segment/parts/seeds.h"

namespace chartflood {

namespace {

std::string repairsText(const Mesh& mesh) {
  std::string text;
  for (const Repair& repair : mesh.repairs()) {
    if (!text.empty()) text += ' ';
    text += repair.text;
  }
  return text;
}

}  // namespace

void Pipeline::setMesh(std::shared_ptr<const Mesh> mesh, double readMilliseconds,
                       Progress& progress) {
  run_.timing = {.read = readMilliseconds};
  run_.start.seeds.clear();
  run_.start.offsets.clear();
  run_.start.normals.clear();
  document_.seeds.clear();
  document_.hints.clear();
  takeMesh(std::move(mesh));
  makeGaussArea(progress);
  makeGraph(progress);
}

/// Nothing that was made of the old mesh stays.
void Pipeline::takeMesh(std::shared_ptr<const Mesh> mesh) {
  mesh_ = std::move(mesh);
  features_ = featureCount(*mesh_);
  ++meshVersion_;
  const FloodStart start = std::move(run_.start);
  const Timing timing = run_.timing;
  run_ = ChartRun{};
  run_.start = start;
  run_.timing = timing;
  overtaken_ = false;
  kept_.clear();
  chartRuns_.reset();
  toldCharts_ = 0;
  toldLiteral_ = false;
  tell(Notice::Kind::Info, "Loaded " + std::to_string(mesh_->triangleCount()) + " triangles in " +
                               std::to_string(mesh_->componentCount()) +
                               (mesh_->componentCount() == 1 ? " part." : " parts."));
  if (!mesh_->repairs().empty()) tell(Notice::Kind::Warning, repairsText(*mesh_));
}

void Pipeline::glueAnew(Progress& progress) {
  progress.beginPhase("Gluing faces");
  const std::shared_ptr<const Mesh> old = mesh_;
  takeMesh(buildMesh(old->sharedInput(), weldDistance(document_.parameters)));
  bool sameFaces = old->faceCount() == mesh_->faceCount();
  for (Index f = 0; sameFaces && f < mesh_->faceCount(); ++f) {
    sameFaces = old->inputFace(f) == mesh_->inputFace(f);
  }
  run_.start.offsets.clear();
  run_.start.normals.clear();
  // Other parts want other seeds; those placed by hand stay where faces have the same numbers.
  run_.start.seeds = seedFaces(document_.seeds);
  if (sameFaces) return;
  run_.start.seeds.clear();
  document_.seeds.clear();
  document_.hints.clear();
  seedsVoid_ = true;
}

void Pipeline::makeGaussArea(Progress& progress) {
  progress.beginPhase("Measuring Gauss area");
  const Stopwatch stopwatch;
  gauss_ =
      std::make_shared<const GaussArea>(computeGaussArea(*mesh_, document_.parameters.sharpAngle));
  ++gaussVersion_;
  run_.timing.gaussArea = stopwatch.milliseconds();
  if (gauss_->total() < 1e-9 && document_.parameters.areaShare > 0) {
    tell(Notice::Kind::Info, "This model has no curvature; balance is by surface area instead.");
  }
}

void Pipeline::makeGraph(Progress& progress) {
  progress.beginPhase("Preparing the flood");
  const Stopwatch stopwatch;
  const Parameters& p = document_.parameters;
  graph_ = std::make_shared<const FloodGraph>(
      buildFloodGraph(*mesh_, *gauss_, {p.speedPower, p.speedEpsilon, p.areaShare}));
  run_.timing.floodGraph = stopwatch.milliseconds();
}

void Pipeline::makeGround(const Parameters& before, Progress& progress) {
  Stage stage = Stage::Layout;
  if (!firstDifference(before, document_.parameters, stage)) return;
  if (stage == Stage::Mesh) glueAnew(progress);
  if (stage <= Stage::Gauss) makeGaussArea(progress);
  if (stage <= Stage::Graph) makeGraph(progress);
}

void Pipeline::dropNewestSeeds(std::size_t wanted) {
  const std::vector<Index> locked = lockedFaces(document_.seeds);
  std::vector<PlacedSeed> seeds;
  for (const Index face : run_.start.seeds) {
    const bool stays = std::find(locked.begin(), locked.end(), face) != locked.end();
    seeds.push_back({face, stays});
  }
  dropNewestUnlocked(seeds, wanted);
  run_.start.seeds = seedFaces(seeds);
}

void Pipeline::reviseSeeds(const Document& before) {
  const Parameters& now = document_.parameters;
  const std::vector<Index> placed = seedFaces(document_.seeds);
  // Seeds that only moved keep their charts' offsets: the others' borders stay about where they
  // are.
  // Seeds that were dropped because of fewer charts leave the others where the rounds took them.
  const Document followed = withFittingSeeds(before, {now, before.seeds, before.hints});
  const std::vector<Index> old = run_.start.seeds;
  if (document_.seeds != before.seeds && document_.seeds != followed.seeds)
    run_.start.seeds = placed;
  // What one method's rounds arrived at is no beginning for another's.
  if (now.method != before.parameters.method) {
    run_.start.seeds = placed;
    run_.start.offsets.clear();
  }
  if (now.rngSeed != before.parameters.rngSeed) run_.start.seeds = placed;
  if (chartsInForce(now, features_) != chartsInForce(before.parameters, features_)) {
    dropNewestSeeds(effectiveChartCount(*mesh_, wantedCharts()));
    run_.start.offsets.clear();
    toldCharts_ = 0;
  }
  // Offsets are Gauss areas: they mean nothing once these are measured differently.
  if (now.sharpAngle != before.parameters.sharpAngle ||
      run_.start.seeds.size() != run_.start.offsets.size()) {
    run_.start.offsets.clear();
  }
  // Normals belong to charts grown from just these seeds.
  if (run_.start.seeds != old) run_.start.normals.clear();
}

bool Pipeline::apply(const Document& document, bool live, Progress& progress) {
  const Document before = std::exchange(document_, document);
  Stage stage = Stage::Layout;
  bool changed = firstDifference(before.parameters, document.parameters, stage);
  if (before.hints != document.hints) {
    stage = std::min(stage, Stage::Refine);
    changed = true;
  }
  // The end of a drag that did not flood gives the same values once more and wants its charts.
  const bool overdue = live && stale();
  if (!mesh_ || (!changed && before.seeds == document.seeds && !overdue)) return false;
  const bool samePlaces =
      before.seeds == document.seeds || seedFaces(document.seeds) == run_.start.seeds;
  // What comes after the labels leaves them as they are.
  if (stage >= Stage::Cut && before.seeds == document.seeds && !overdue) return false;
  if (stage >= Stage::Cut && samePlaces && run_.stepper) {  // nor do locks
    run_.locksChanged = true;
    return false;
  }
  // Nor do rounds to come change charts that are finished.
  const bool onlyRounds = differOnlyInRounds(before.parameters, document.parameters) &&
                          before.seeds == document.seeds && before.hints == document.hints;
  if (standing() && onlyRounds) return false;
  const bool hadCharts = run_.stepper != nullptr || run_.segmentation != nullptr;
  // Another method begins from its own seeds: where charts were finished, its own are made.
  const bool otherMethod =
      standing() && (document.parameters.method != before.parameters.method ||
                     (document.parameters.start != before.parameters.start &&
                      run_.start.creases.has_value() != wantsCreases().has_value()) ||
                     (document.parameters.search != before.parameters.search &&
                      run_.start.fast.has_value() != wantsFast().has_value()));
  const bool keepFinal = standing() && samePlaces && stage >= Stage::Iterations;
  setAside();  // as it is: what is revised next is the beginning of other charts
  reviseSeeds(before);
  makeGround(before.parameters, progress);
  if (!hadCharts || !live) return true;
  // Where only later stages changed, the finished charts are finished again in the new way.
  const std::optional<std::uint32_t> creases = keepFinal ? run_.start.creases : wantsCreases();
  // Middles of charts from creases are no beginning for a flood.
  if (creases != run_.start.creases) {
    run_.start.seeds = seedFaces(document.seeds);
    run_.start.offsets.clear();
    run_.start.normals.clear();
  }
  makeStepper(keepFinal ? 1 : static_cast<std::size_t>(document.parameters.maxIterations), creases,
              keepFinal ? run_.start.fast : wantsFast());
  const Stopwatch stopwatch;
  const bool toTheEnd = keepFinal || otherMethod;
  run_.stepper->advance(toTheEnd ? StepUnit::Converged : StepUnit::Flood, 1, progress);
  keepFlood();
  run_.timing.segment = stopwatch.milliseconds();
  return true;
}

bool Pipeline::standsAt(const FloodMoment& moment) const {
  return run_.stepper && run_.stepper->record() && run_.start == moment.start &&
         finished() == moment.finished && run_.stepper->record()->size() == moment.taken;
}

bool Pipeline::restore(const Document& document, const FloodMoment& moment, Progress& progress) {
  const Document before = std::exchange(document_, document);
  if (!mesh_) return false;
  Stage stage = Stage::Layout;
  firstDifference(before.parameters, document.parameters, stage);
  if (before.hints != document.hints) stage = std::min(stage, Stage::Refine);
  if (stage >= Stage::Cut && (standing() || !finished()) &&
      standsAt(moment)) {  // what comes after the labels, or locks
    run_.locksChanged = run_.locksChanged || before.seeds != document.seeds;
    return false;
  }
  setAside();
  // Charts that were finished before, or by a search for their number, need not be made again.
  if (std::optional<ChartRun> kept = kept_.take(document, &moment)) {
    takeOver(*std::move(kept));
    return false;
  }
  makeGround(before.parameters, progress);
  if (seedsVoid_) return true;
  run_.start = moment.start;
  makeStepper(moment.finished ? 1 : static_cast<std::size_t>(document.parameters.maxIterations),
              moment.start.creases, moment.start.fast);
  const Stopwatch stopwatch;
  if (moment.finished) {
    run_.stepper->advance(StepUnit::Converged, 1, progress);
  } else if (moment.taken >= mesh_->faceCount()) {
    run_.stepper->advance(StepUnit::Flood, 1, progress);
  } else if (moment.taken > 0) {
    run_.stepper->advance(StepUnit::Face, moment.taken, progress);
  }
  keepFlood();
  run_.timing.segment = stopwatch.milliseconds();
  return true;
}

void Pipeline::measure() {
  if (!run_.stepper) return;
  std::shared_ptr<const Segmentation> now = run_.stepper->state();
  const bool same = run_.segmentation && now->label == run_.segmentation->label;
  for (FlatStages* flat : {&run_.flat, &run_.shownFlat}) {
    if (same && flat->of == run_.segmentation) flat->of = now;
  }
  if (!same) run_.unwrapAsked = false;
  run_.segmentation = std::move(now);
  run_.stats = std::make_shared<const ChartStats>(measureCharts(*mesh_, *run_.segmentation));
}

void Pipeline::report(Results& results) const {
  results.meshVersion = meshVersion_;
  results.gaussVersion = gaussVersion_;
  results.mesh = mesh_;
  results.gaussArea = gauss_;
  results.segmentation = run_.segmentation;
  results.chartStats = run_.stats;
  results.charts = run_.shownFlat.charts;
  results.unwrap = run_.shownFlat.unwrap;
  results.atlas = run_.shownFlat.atlas;
  results.flat = isFlat();
  results.finished = finished();
  results.stale = stale();
  results.unsettled = unsettled();
  results.sketch = run_.depth == Depth::Sketch;
  results.timing = run_.timing;
  results.parameters = document_.parameters;
  results.features = features_;
  results.placed = document_.seeds;
  results.seedRuns = run_.seedRuns;
  results.chartRuns = chartRuns_;
  if (!run_.stepper) return;
  reportRounds(results);
  results.record = run_.flood;
  results.start = run_.start;
}

void Pipeline::reportRounds(Results& results) const {
  if (!run_.stepper) {  // one is being made
    results.history.clear();
    results.floods.clear();
    results.bestIteration = 0;
    results.stopReason = StopReason::NotStopped;
    results.seamRecord.reset();
    return;
  }
  results.history.assign(run_.stepper->history().begin(), run_.stepper->history().end());
  results.bestIteration = run_.stepper->bestIteration();
  results.stopReason = run_.stepper->stopReason();
  results.seamRecord = run_.stepper->seamRecord();
  results.floods.assign(run_.floods.records().begin(), run_.floods.records().end());
  results.floods.resize(results.history.size());
  results.recordIteration = run_.floodRound;
}

}  // namespace chartflood
