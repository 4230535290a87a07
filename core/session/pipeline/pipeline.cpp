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
  timing_ = {.read = readMilliseconds};
  start_.seeds.clear();
  start_.offsets.clear();
  start_.normals.clear();
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
  stepper_.reset();
  flood_.reset();
  floods_.clear();
  segmentation_.reset();
  stats_.reset();
  flat_ = shownFlat_ = {};
  unwrapAsked_ = false;
  chartRuns_.reset();
  found_.reset();
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
  start_.offsets.clear();
  start_.normals.clear();
  // Other parts want other seeds; those placed by hand stay where faces have the same numbers.
  start_.seeds = seedFaces(document_.seeds);
  if (sameFaces) return;
  start_.seeds.clear();
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
  timing_.gaussArea = stopwatch.milliseconds();
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
  timing_.floodGraph = stopwatch.milliseconds();
}

void Pipeline::dropNewestSeeds(std::size_t wanted) {
  const std::vector<Index> locked = lockedFaces(document_.seeds);
  std::vector<PlacedSeed> seeds;
  for (const Index face : start_.seeds) {
    const bool stays = std::find(locked.begin(), locked.end(), face) != locked.end();
    seeds.push_back({face, stays});
  }
  dropNewestUnlocked(seeds, wanted);
  start_.seeds = seedFaces(seeds);
}

void Pipeline::reviseSeeds(const Document& before) {
  const Parameters& now = document_.parameters;
  const std::vector<Index> placed = seedFaces(document_.seeds);
  // Seeds that only moved keep their charts' offsets: the others' borders stay about where they
  // are.
  // Seeds that were dropped because of fewer charts leave the others where the rounds took them.
  const Document followed = withFittingSeeds(before, {now, before.seeds, before.hints});
  const std::vector<Index> old = start_.seeds;
  if (document_.seeds != before.seeds && document_.seeds != followed.seeds) start_.seeds = placed;
  // What one method's rounds arrived at is no beginning for another's.
  if (now.method != before.parameters.method) {
    start_.seeds = placed;
    start_.offsets.clear();
  }
  if (now.rngSeed != before.parameters.rngSeed) start_.seeds = placed;
  if (chartsInForce(now, features_) != chartsInForce(before.parameters, features_)) {
    dropNewestSeeds(effectiveChartCount(*mesh_, wantedCharts()));
    start_.offsets.clear();
    toldCharts_ = 0;
  }
  // Offsets are Gauss areas: they mean nothing once these are measured differently.
  if (now.sharpAngle != before.parameters.sharpAngle ||
      start_.seeds.size() != start_.offsets.size()) {
    start_.offsets.clear();
  }
  // Normals belong to charts grown from just these seeds.
  if (start_.seeds != old) start_.normals.clear();
}

bool Pipeline::apply(const Document& document, bool live, Progress& progress) {
  const Document before = std::exchange(document_, document);
  if (before != document) found_.reset();
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
      before.seeds == document.seeds || seedFaces(document.seeds) == start_.seeds;
  // What comes after the labels leaves them as they are.
  if (stage >= Stage::Cut && before.seeds == document.seeds && !overdue) return false;
  if (stage >= Stage::Cut && samePlaces && stepper_) {  // nor do locks
    locksChanged_ = true;
    return false;
  }
  // Nor do rounds to come change charts that are finished.
  const bool onlyRounds = differOnlyInRounds(before.parameters, document.parameters) &&
                          before.seeds == document.seeds && before.hints == document.hints;
  if (finished() && onlyRounds) return false;
  const bool hadCharts = stepper_ != nullptr || segmentation_ != nullptr;
  // Another method begins from its own seeds: where charts were finished, its own are made.
  const bool otherMethod =
      finished() && (document.parameters.method != before.parameters.method ||
                     (document.parameters.start != before.parameters.start &&
                      start_.creases.has_value() != wantsCreases().has_value()) ||
                     (document.parameters.search != before.parameters.search &&
                      start_.fast.has_value() != wantsFast().has_value()));
  const bool keepFinal = finished() && samePlaces && stage >= Stage::Iterations;
  reviseSeeds(before);
  stepper_.reset();
  if (changed && stage == Stage::Mesh) glueAnew(progress);
  if (changed && stage <= Stage::Gauss) makeGaussArea(progress);
  if (changed && stage <= Stage::Graph) makeGraph(progress);
  if (!hadCharts || !live) return true;
  // Where only later stages changed, the finished charts are finished again in the new way.
  const std::optional<std::uint32_t> creases = keepFinal ? start_.creases : wantsCreases();
  // Middles of charts from creases are no beginning for a flood.
  if (creases != start_.creases) {
    start_.seeds = seedFaces(document.seeds);
    start_.offsets.clear();
    start_.normals.clear();
  }
  makeStepper(keepFinal ? 1 : static_cast<std::size_t>(document.parameters.maxIterations), creases,
              keepFinal ? start_.fast : wantsFast());
  const Stopwatch stopwatch;
  const bool toTheEnd = keepFinal || otherMethod;
  stepper_->advance(toTheEnd ? StepUnit::Converged : StepUnit::Flood, 1, progress);
  keepFlood();
  timing_.segment = stopwatch.milliseconds();
  return true;
}

bool Pipeline::standsAt(const FloodMoment& moment) const {
  return stepper_ && stepper_->record() && start_ == moment.start &&
         finished() == moment.finished && stepper_->record()->size() == moment.taken;
}

void Pipeline::restore(const Document& document, const FloodMoment& moment, Progress& progress) {
  const Document before = std::exchange(document_, document);
  if (!mesh_) return;
  Stage stage = Stage::Layout;
  const bool changed = firstDifference(before.parameters, document.parameters, stage);
  if (before.hints != document.hints) stage = std::min(stage, Stage::Refine);
  if (stage >= Stage::Cut && standsAt(moment)) {  // what comes after the labels, or locks
    locksChanged_ = locksChanged_ || before.seeds != document.seeds;
    return;
  }
  const std::unique_ptr<Pipeline> found = std::move(found_);
  stepper_.reset();
  if (changed && stage == Stage::Mesh) glueAnew(progress);
  if (changed && stage <= Stage::Gauss) makeGaussArea(progress);
  if (changed && stage <= Stage::Graph) makeGraph(progress);
  if (seedsVoid_) return;
  // The charts of a search for their number need not be made again.
  if (found && found->mesh_ == mesh_ && found->document_ == document &&
      found->asRun(false).moment == moment) {
    seedRuns_.reset();
    return takeOver(*found);
  }
  start_ = moment.start;
  makeStepper(moment.finished ? 1 : static_cast<std::size_t>(document.parameters.maxIterations),
              moment.start.creases, moment.start.fast);
  const Stopwatch stopwatch;
  if (moment.finished) {
    stepper_->advance(StepUnit::Converged, 1, progress);
  } else if (moment.taken >= mesh_->faceCount()) {
    stepper_->advance(StepUnit::Flood, 1, progress);
  } else if (moment.taken > 0) {
    stepper_->advance(StepUnit::Face, moment.taken, progress);
  }
  keepFlood();
  timing_.segment = stopwatch.milliseconds();
}

void Pipeline::measure() {
  if (!stepper_) return;
  std::shared_ptr<const Segmentation> now = stepper_->state();
  const bool same = segmentation_ && now->label == segmentation_->label;
  for (Flat* flat : {&flat_, &shownFlat_}) {
    if (same && flat->of == segmentation_) flat->of = now;
  }
  if (!same) unwrapAsked_ = false;
  segmentation_ = std::move(now);
  stats_ = std::make_shared<const ChartStats>(measureCharts(*mesh_, *segmentation_));
}

void Pipeline::report(Results& results) const {
  results.meshVersion = meshVersion_;
  results.gaussVersion = gaussVersion_;
  results.mesh = mesh_;
  results.gaussArea = gauss_;
  results.segmentation = segmentation_;
  results.chartStats = stats_;
  results.charts = shownFlat_.charts;
  results.unwrap = shownFlat_.unwrap;
  results.atlas = shownFlat_.atlas;
  results.flat = isFlat();
  results.finished = finished();
  results.stale = stale();
  results.timing = timing_;
  results.parameters = document_.parameters;
  results.features = features_;
  results.placed = document_.seeds;
  results.seedRuns = seedRuns_;
  results.chartRuns = chartRuns_;
  if (stepper_) reportRounds(results);
}

void Pipeline::reportRounds(Results& results) const {
  if (!stepper_) {  // one is being made
    results.history.clear();
    results.floods.clear();
    results.bestIteration = 0;
    results.stopReason = StopReason::NotStopped;
    results.seamRecord.reset();
    return;
  }
  results.history.assign(stepper_->history().begin(), stepper_->history().end());
  results.bestIteration = stepper_->bestIteration();
  results.stopReason = stepper_->stopReason();
  results.seamRecord = stepper_->seamRecord();
  results.floods.assign(floods_.records().begin(), floods_.records().end());
  results.floods.resize(results.history.size());
  results.recordIteration = floodRound_;
}

}  // namespace chartflood
