#include "core/session/pipeline.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "core/charts/chart_stats.h"
#include "core/charts/cut_charts.h"
#include "core/flood/build_flood_graph.h"
#include "core/gauss/compute_gauss_area.h"
#include "core/pack/layout_atlas.h"
#include "core/param/unwrap_charts.h"
#include "core/segment/crease_start.h"
#include "core/segment/hint_factors.h"
#include "core/segment/registry.h"
#include "core/segment/seeds.h"

namespace chartflood {

namespace {

using Clock = std::chrono::steady_clock;

double millisecondsSince(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

VsaSeeding vsaSeeding(const std::string& id) {
  return id == "doubling" ? VsaSeeding::Doubling
         : id == "random" ? VsaSeeding::Random
                          : VsaSeeding::OneByOne;
}

std::string repairsText(const Mesh& mesh) {
  std::string text;
  for (const Repair& repair : mesh.repairs()) {
    if (!text.empty()) text += ' ';
    text += repair.text;
  }
  return text;
}

RefineOptions refineOptions(const Parameters& p) {
  RefineOptions options;
  options.kind = p.refine == "cuts"    ? RefineKind::Cuts
                 : p.refine == "moves" ? RefineKind::Moves
                                       : RefineKind::None;
  options.balanceWeight = p.balanceWeight;
  options.creaseWeight = p.creaseWeight;
  options.cleanUp = p.cleanUp;
  return options;
}

template <class Work>
void timed(double& milliseconds, Work&& work) {
  const Clock::time_point start = Clock::now();
  work();
  milliseconds = millisecondsSince(start);
}

}  // namespace

void Pipeline::tell(Notice::Kind kind, std::string text) const {
  listener_.onNotice({kind, std::move(text)});
}

void Pipeline::setMesh(std::shared_ptr<const Mesh> mesh, double readMilliseconds,
                       Progress& progress) {
  mesh_ = std::move(mesh);
  ++meshVersion_;
  timing_ = {.read = readMilliseconds};
  stepper_.reset();
  flood_.reset();
  floods_.clear();
  segmentation_.reset();
  stats_.reset();
  flat_ = shownFlat_ = {};
  unwrapAsked_ = false;
  seeds_.clear();
  offsets_.clear();
  normals_.clear();
  document_.seeds.clear();
  document_.hints.clear();
  chartRuns_.reset();
  toldCharts_ = 0;
  tell(Notice::Kind::Info, "Loaded " + std::to_string(mesh_->triangleCount()) + " triangles in " +
                               std::to_string(mesh_->componentCount()) +
                               (mesh_->componentCount() == 1 ? " part." : " parts."));
  if (!mesh_->repairs().empty()) tell(Notice::Kind::Warning, repairsText(*mesh_));
  makeGaussArea(progress);
  makeGraph(progress);
}

void Pipeline::makeGaussArea(Progress& progress) {
  progress.beginPhase("Measuring Gauss area");
  const Clock::time_point start = Clock::now();
  gauss_ =
      std::make_shared<const GaussArea>(computeGaussArea(*mesh_, document_.parameters.sharpAngle));
  ++gaussVersion_;
  timing_.gaussArea = millisecondsSince(start);
  if (gauss_->total() < 1e-9 && document_.parameters.areaShare > 0) {
    tell(Notice::Kind::Info, "This model has no curvature; balance is by surface area instead.");
  }
}

void Pipeline::makeGraph(Progress& progress) {
  progress.beginPhase("Preparing the flood");
  const Clock::time_point start = Clock::now();
  const Parameters& p = document_.parameters;
  graph_ = std::make_shared<const FloodGraph>(
      buildFloodGraph(*mesh_, *gauss_, {p.speedPower, p.speedEpsilon, p.areaShare}));
  timing_.floodGraph = millisecondsSince(start);
}

bool Pipeline::finished() const { return stepper_ != nullptr && stepper_->finished(); }

void Pipeline::dropNewestSeeds(std::size_t wanted) {
  const std::vector<Index> locked = lockedFaces(document_.seeds);
  std::vector<PlacedSeed> seeds;
  for (const Index face : seeds_) {
    const bool stays = std::find(locked.begin(), locked.end(), face) != locked.end();
    seeds.push_back({face, stays});
  }
  dropNewestUnlocked(seeds, wanted);
  seeds_ = seedFaces(seeds);
}

void Pipeline::reviseSeeds(const Document& before) {
  const Parameters& now = document_.parameters;
  const std::vector<Index> placed = seedFaces(document_.seeds);
  // Seeds that only moved keep their charts' offsets: the others' borders stay about where they
  // are.
  // Seeds that were dropped because of fewer charts leave the others where the rounds took them.
  const Document followed = withFittingSeeds(before, {now, before.seeds, before.hints});
  const std::vector<Index> old = seeds_;
  if (document_.seeds != before.seeds && document_.seeds != followed.seeds) seeds_ = placed;
  // What one method's rounds arrived at is no beginning for another's.
  if (now.method != before.parameters.method) {
    seeds_ = placed;
    offsets_.clear();
  }
  if (now.rngSeed != before.parameters.rngSeed) seeds_ = placed;
  if (now.charts != before.parameters.charts) {
    dropNewestSeeds(static_cast<std::size_t>(now.charts));
    offsets_.clear();
    toldCharts_ = 0;
  }
  // Offsets are Gauss areas: they mean nothing once these are measured differently.
  if (now.sharpAngle != before.parameters.sharpAngle || seeds_.size() != offsets_.size()) {
    offsets_.clear();
  }
  // Normals belong to charts grown from just these seeds.
  if (seeds_ != old) normals_.clear();
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
  const bool samePlaces = before.seeds == document.seeds || seedFaces(document.seeds) == seeds_;
  // What comes after the labels leaves them as they are.
  if (stage >= Stage::Cut && before.seeds == document.seeds && !overdue) return false;
  if (stage >= Stage::Cut && samePlaces && stepper_) {  // nor do locks
    locksChanged_ = true;
    return false;
  }
  const bool hadCharts = stepper_ != nullptr || segmentation_ != nullptr;
  // Another method begins from its own seeds: where charts were finished, its own are made.
  const bool otherMethod = finished() && (document.parameters.method != before.parameters.method ||
                                          (document.parameters.start != before.parameters.start &&
                                           creases_.has_value() != wantsCreases().has_value()));
  const bool keepFinal = finished() && samePlaces && stage >= Stage::Iterations;
  reviseSeeds(before);
  stepper_.reset();
  if (changed && stage <= Stage::Gauss) makeGaussArea(progress);
  if (changed && stage <= Stage::Graph) makeGraph(progress);
  if (!hadCharts || !live) return true;
  // Where only later stages changed, the finished charts are finished again in the new way.
  const std::optional<std::uint32_t> creases = keepFinal ? creases_ : wantsCreases();
  // Middles of charts from creases are no beginning for a flood.
  if (creases != creases_) {
    seeds_ = seedFaces(document.seeds);
    offsets_.clear();
    normals_.clear();
  }
  makeStepper(keepFinal ? 1 : static_cast<std::size_t>(document.parameters.maxIterations), creases);
  const Clock::time_point start = Clock::now();
  const bool toTheEnd = keepFinal || otherMethod;
  stepper_->advance(toTheEnd ? StepUnit::Converged : StepUnit::Flood, 1, progress);
  keepFlood();
  timing_.segment = millisecondsSince(start);
  return true;
}

bool Pipeline::standsAt(const FloodMoment& moment) const {
  return stepper_ && stepper_->record() && seeds_ == moment.seeds && offsets_ == moment.offsets &&
         normals_ == moment.normals && creases_ == moment.creases &&
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
  stepper_.reset();
  if (changed && stage <= Stage::Gauss) makeGaussArea(progress);
  if (changed && stage <= Stage::Graph) makeGraph(progress);
  seeds_ = moment.seeds;
  offsets_ = moment.offsets;
  normals_ = moment.normals;
  makeStepper(moment.finished ? 1 : static_cast<std::size_t>(document.parameters.maxIterations),
              moment.creases);
  const Clock::time_point start = Clock::now();
  if (moment.finished) {
    stepper_->advance(StepUnit::Converged, 1, progress);
  } else if (moment.taken >= mesh_->faceCount()) {
    stepper_->advance(StepUnit::Flood, 1, progress);
  } else if (moment.taken > 0) {
    stepper_->advance(StepUnit::Face, moment.taken, progress);
  }
  keepFlood();
  timing_.segment = millisecondsSince(start);
}

void Pipeline::takeLocks(Progress& progress) {
  const std::size_t taken = stepper_->record() ? stepper_->record()->size() : mesh_->faceCount();
  makeStepper(static_cast<std::size_t>(document_.parameters.maxIterations));
  if (taken > 0) stepper_->advance(StepUnit::Face, taken, progress);
  keepFlood();
}

std::optional<std::uint32_t> Pipeline::wantsCreases() const {
  const Parameters& p = document_.parameters;
  const bool wanted =
      p.method == "t-flooding" && document_.seeds.empty() &&
      (p.start == "creases" || (p.start == "auto" && suitsCreaseStart({mesh_, gauss_, graph_})));
  return wanted ? std::optional(static_cast<std::uint32_t>(p.rngSeed)) : std::nullopt;
}

void Pipeline::makeStepper(std::size_t maxIterations) {
  makeStepper(maxIterations, wantsCreases());
}

void Pipeline::makeStepper(std::size_t maxIterations, std::optional<std::uint32_t> creases) {
  const Parameters& p = document_.parameters;
  SegmentOptions options;
  options.charts = static_cast<std::size_t>(p.charts);
  options.seeds = seeds_.empty() ? seedFaces(document_.seeds) : seeds_;
  options.locked = lockedFaces(document_.seeds);
  locksChanged_ = false;
  options.offsets = offsets_;
  options.normals = normals_;
  options.rngSeed = creases.value_or(static_cast<std::uint32_t>(p.rngSeed));
  options.useOffsets = p.offsets;
  options.offsetDamping = p.offsetDamping;
  options.lookahead = p.lookahead;
  options.maxIterations = maxIterations;
  options.patience = static_cast<std::size_t>(p.patience);
  options.detectCycles = p.detectCycles;
  options.settle = static_cast<std::size_t>(p.settle);
  options.keepLast = p.keep == "last";
  options.refine = refineOptions(p);
  options.refine.sideFactor = hintFactors(*mesh_, document_.hints);
  options.vsa = {vsaSeeding(p.vsaSeeding), p.vsaTeleport};
  options.mcgim = {p.mcgimLambda, p.mcgimNormals == "running", p.mcgimDisks};
  seedRuns_.reset();
  onFlood_ = std::make_shared<std::function<void(const FloodStart&)>>(
      [this](const FloodStart& start) { noteFlood(start); });
  options.onFlood = [told = onFlood_](const FloodStart& start) { (*told)(start); };
  stepper_.reset();
  flood_.reset();
  floods_.clear();
  roundsSeen_ = 0;
  const SegmentInputs inputs{mesh_, gauss_, graph_};
  creases_ = creases;
  stepper_ =
      creases ? makeCreaseStart(inputs, options) : findSegmenter(p.method)->make(inputs, options);
  timing_.segment = 0;
  tellChartCount();
}

void Pipeline::keepFlood() {
  if (!stepper_ || !flood_) return;
  const std::size_t rounds = stepper_->history().size();
  // A flood that was begun again ends as a new round.
  const std::size_t round = rounds > roundsSeen_ ? rounds - 1 : floodRound_;
  roundsSeen_ = rounds;
  if (round >= rounds || flood_->size() < flood_->capacity()) return;
  floodRound_ = round;
  floods_.keep(round, flood_, stepper_->bestIteration());
}

void Pipeline::noteFlood(const FloodStart& start) {
  keepFlood();
  flood_ = start.record;
  floodRound_ = start.iteration;
  seeds_.assign(start.seeds.begin(), start.seeds.end());
  offsets_.assign(start.offsets.begin(), start.offsets.end());
  normals_.assign(start.normals.begin(), start.normals.end());
  listener_.onFlood(start);
}

StepOutcome Pipeline::step(StepUnit unit, std::size_t count, Progress& progress) {
  const Clock::time_point start = Clock::now();
  // Who steps on from finished charts wants more rounds: these begin from the best one's seeds.
  if (!stepper_ || finished()) {
    progress.beginPhase("Placing seeds");
    makeStepper(static_cast<std::size_t>(document_.parameters.maxIterations));
  } else if (locksChanged_) {
    takeLocks(progress);
  }
  const StepOutcome outcome = stepper_->advance(unit, count, progress);
  keepFlood();
  timing_.segment += millisecondsSince(start);
  if (outcome == StepOutcome::Finished) tellOutcome();
  return outcome;
}

void Pipeline::restartFlood() {
  if (stepper_) stepper_->restartFlood();
}

void Pipeline::resetSeeds() {
  seeds_.clear();
  offsets_.clear();
  normals_.clear();
  if (stepper_) makeStepper(static_cast<std::size_t>(document_.parameters.maxIterations));
}

StepOutcome Pipeline::adopt(std::size_t iteration, Progress& progress) {
  if (!stepper_ || iteration >= stepper_->history().size()) return StepOutcome::Advanced;
  const StepOutcome outcome = stepper_->adopt(iteration, progress);
  keepFlood();
  return outcome;
}

void Pipeline::recall(std::size_t iteration, Progress& progress) {
  if (!stepper_ || iteration >= stepper_->history().size()) return;
  const auto kept = floods_.records();
  std::shared_ptr<const FloodRecord> record = iteration < kept.size() ? kept[iteration] : nullptr;
  if (!record) record = stepper_->replay(iteration, progress);
  if (record) floods_.recall(iteration, std::move(record));
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

bool Pipeline::isFlat() const {
  Stage stage;
  const bool differs = firstDifference(shownFlat_.parameters, document_.parameters, stage);
  return shownFlat_.atlas && !stale() && shownFlat_.of == segmentation_ &&
         !(differs && stage >= Stage::Cut);
}

bool Pipeline::awaitsUnwrap() const {
  return complete() && !isFlat() && (finished() || unwrapAsked_);
}

void Pipeline::dropStaleFlat() {
  Stage stage = Stage::Layout;
  const bool changed = firstDifference(flat_.parameters, document_.parameters, stage);
  if (flat_.of != segmentation_ || (changed && stage <= Stage::Cut)) flat_ = {};
  if (changed && stage <= Stage::Unwrap) {
    flat_.charts.reset();
    flat_.unwrap.reset();
  }
  if (changed) flat_.atlas.reset();
  flat_.of = segmentation_;
  flat_.parameters = document_.parameters;
}

bool Pipeline::layFlat(Progress& progress) {
  dropStaleFlat();
  const Parameters& p = document_.parameters;
  if (!flat_.cut) {
    progress.beginPhase("Cutting into disks");
    CutOptions options{p.cutHandles, p.cutLoops, p.cutTips, p.tip};
    const bool wavefront = p.handleSearch == "wavefront";
    options.handleSearch = wavefront ? HandleSearch::Wavefront : HandleSearch::Shortest;
    options.seed = static_cast<std::uint32_t>(p.rngSeed);
    timed(timing_.cut, [&] { flat_.cut = cutCharts(*mesh_, *segmentation_, options, progress); });
    if (!flat_.cut) return false;
  }
  if (!flat_.unwrap) {
    progress.beginPhase("Laying charts flat");
    using Boundary = UnwrapOptions::Boundary;
    const UnwrapOptions options{p.unwrap == "circle" ? Boundary::Circle : Boundary::Free,
                                p.reliefStretch};
    timed(timing_.unwrap, [&] {
      UnwrapResult result = unwrapCharts(*mesh_, flat_.cut, options, progress);
      flat_.charts = std::move(result.charts);
      flat_.unwrap = std::move(result.unwrap);
    });
    if (!flat_.unwrap) return false;
  }
  return true;
}

bool Pipeline::unwrap(Progress& progress) {
  unwrapAsked_ = true;
  if (!layFlat(progress)) return false;
  const Parameters& p = document_.parameters;
  if (!flat_.atlas) {
    progress.beginPhase("Packing the texture");
    using Kind = LayoutOptions::Kind;
    const LayoutOptions options{p.layout == "square" ? Kind::Square : Kind::Packed, p.textureSize,
                                p.margin};
    timed(timing_.pack,
          [&] { flat_.atlas = layoutAtlas(*flat_.charts, *flat_.unwrap, options, progress); });
    if (!flat_.atlas) return false;
  }
  const bool cutAnew = shownFlat_.charts != flat_.charts;
  shownFlat_ = flat_;
  if (cutAnew) tellNotFlat();
  return true;
}

void Pipeline::tellNotFlat() const {
  for (std::size_t c = 0; c < flat_.unwrap->charts.size(); ++c) {
    const std::string& problem = flat_.unwrap->charts[c].problem;
    if (problem.empty()) continue;
    tell(Notice::Kind::Warning,
         "Chart " + std::to_string(c) + " could not be flattened: " + problem);
  }
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

void Pipeline::tellChartCount() {
  const std::size_t wanted = static_cast<std::size_t>(document_.parameters.charts);
  // Methods that come to their charts one by one begin with fewer seeds.
  const std::size_t locks = lockedFaces(document_.seeds).size();
  const std::size_t count =
      effectiveChartCount(*mesh_, document_.parameters.method == "t-flooding"
                                      ? seeds_.size()
                                      : std::max({wanted, locks, seeds_.size()}));
  if (count == wanted || count == toldCharts_) return;
  toldCharts_ = count;
  const std::string number = std::to_string(count);
  const std::size_t locked = lockedFaces(document_.seeds).size();
  if (count < wanted) {
    tell(Notice::Kind::Warning, "Only " + number + " faces: K was set to " + number + ".");
  } else if (locked > wanted && locked >= mesh_->componentCount()) {
    tell(Notice::Kind::Warning,
         std::to_string(locked) + " seeds are locked, so K was raised to " + number + ".");
  } else if (mesh_->componentCount() > wanted) {
    tell(Notice::Kind::Warning,
         std::to_string(mesh_->componentCount()) +
             " separate parts: each gets at least one chart, so K was raised to " + number + ".");
  }
}

void Pipeline::tellOutcome() {
  if (creases_) return tell(Notice::Kind::Info, "Charts begin from the model's creases.");
  const auto rounds = std::to_string(stepper_->history().size());
  const auto kept =
      "round " + std::to_string(stepper_->state()->iteration + 1) + " of " + rounds + " is kept.";
  switch (stepper_->stopReason()) {
  case StopReason::Converged:
    return tell(Notice::Kind::Info, "Stopped: all seeds rest; " + kept);
  case StopReason::Cycle:
    return tell(Notice::Kind::Info, "Stopped: the seeds returned to an earlier place; " + kept);
  case StopReason::MaxIterations:
    return tell(Notice::Kind::Info, "Stopped after the most iterations allowed; " + kept);
  case StopReason::NoImprovement:
    if (document_.parameters.method != "t-flooding") {
      return tell(Notice::Kind::Info, "Stopped: more rounds bring no better fit; " + kept);
    }
    return tell(Notice::Kind::Info, "Stopped: no better balance for " +
                                        std::to_string(document_.parameters.patience) +
                                        " rounds; " + kept);
  case StopReason::NotStopped:
  case StopReason::Cancelled:
    return;
  }
}

}  // namespace chartflood
