// Rounds of the method: made from the parameters, stepped, and their floods kept.

#include <algorithm>
#include <utility>

#include "core/base/stopwatch.h"
#include "core/segment/borders/hint_factors.h"
#include "core/segment/creases/crease_start.h"
#include "core/segment/fast/fast_flooding.h"
#include "core/segment/registry.h"
#include "core/session/pipeline/pipeline.h"

namespace chartflood {

namespace {

/// --search=auto goes through all rounds on the whole mesh up to so many faces.
constexpr std::size_t kMostLiteralFaces = 300000;

VsaSeeding vsaSeeding(const std::string& id) {
  return id == "doubling" ? VsaSeeding::Doubling
         : id == "random" ? VsaSeeding::Random
                          : VsaSeeding::OneByOne;
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

/// Rounds of a sketch: it begins near where it ends, and meshes that take long go fewer.
std::size_t sketchRounds(const Mesh& mesh) {
  constexpr std::size_t kMost = 8, kLeast = 3, kFaces = 800000;
  return std::clamp(kFaces / std::max<std::size_t>(1, mesh.faceCount()), kLeast, kMost);
}

}  // namespace

void Pipeline::takeLocks(Progress& progress) {
  const std::size_t taken =
      run_.stepper->record() ? run_.stepper->record()->size() : mesh_->faceCount();
  makeStepper(static_cast<std::size_t>(document_.parameters.maxIterations), wantsCreases(),
              run_.start.fast);
  if (taken > 0) run_.stepper->advance(StepUnit::Face, taken, progress);
  keepFlood();
}

std::optional<std::uint32_t> Pipeline::wantsCreases() const {
  const Parameters& p = document_.parameters;
  const auto suits = [&] { return suitsCreaseStart({mesh_, gauss_, graph_}, wantedCharts()); };
  const bool wanted = segmenterOf(p.method).knowsCreases && document_.seeds.empty() &&
                      (p.start == "creases" || (p.start == "auto" && suits()));
  return wanted ? std::optional(static_cast<std::uint32_t>(p.rngSeed)) : std::nullopt;
}

std::optional<FastFlood> Pipeline::wantsFast() const {
  const Parameters& p = document_.parameters;
  const bool sketched = depth_ == Depth::Sketch && p.search != "literal";
  const bool wanted =
      sketched || p.search == "fast" ||
      (p.search == "auto" && p.seeding == "spread" && mesh_->faceCount() > kMostLiteralFaces);
  const bool fits = segmenterOf(p.method).knowsFast && wanted && !wantsCreases();
  return fits ? std::optional(FastFlood{}) : std::nullopt;
}

void Pipeline::makeStepper(std::size_t maxIterations) {
  makeStepper(maxIterations, wantsCreases(), wantsFast());
}

void Pipeline::makeStepper(std::size_t maxIterations, std::optional<std::uint32_t> creases,
                           const std::optional<FastFlood>& fast) {
  setAside();
  run_.document = document_;
  run_.depth = depth_;
  run_.gauss = gauss_;
  run_.graph = graph_;
  run_.gaussVersion = gaussVersion_;
  run_.flood.reset();
  run_.floods.clear();
  run_.roundsSeen = 0;
  run_.seedRuns.reset();
  overtaken_ = false;
  const Parameters& p = document_.parameters;
  SegmentOptions options;
  options.charts = wantedCharts();
  options.seeds = run_.start.seeds.empty() ? seedFaces(document_.seeds) : run_.start.seeds;
  options.locked = lockedFaces(document_.seeds);
  run_.locksChanged = false;
  options.offsets = run_.start.offsets;
  options.normals = run_.start.normals;
  options.rngSeed = creases.value_or(static_cast<std::uint32_t>(p.rngSeed));
  options.creasesFirst = p.start == "creases";
  if (fast) {
    options.search = SearchKind::Fast;
    options.fast = *fast;
    if (depth_ == Depth::Whole && !searchesFast(*mesh_, options)) tellTooSmall();
  }
  options.useOffsets = p.offsets;
  options.offsetDamping = p.offsetDamping;
  options.lookahead = p.lookahead;
  const bool sketch = depth_ == Depth::Sketch;
  options.maxIterations = sketch ? std::min(maxIterations, sketchRounds(*mesh_)) : maxIterations;
  options.patience = static_cast<std::size_t>(p.patience);
  options.detectCycles = p.detectCycles;
  options.settle = static_cast<std::size_t>(p.settle);
  options.keepLast = p.keep == "last";
  options.roundMeasure = p.keep == "eq3" ? RoundMeasure::Printed : RoundMeasure::Relative;
  options.placement = p.seeding == "one-by-one" ? SeedPlacement::OneByOne : SeedPlacement::Spread;
  options.record = logs_ != FloodLogs::None;
  options.refine = refineOptions(p);
  options.refine.sketch = sketch;
  options.refine.sideFactor = hintFactors(*mesh_, document_.hints);
  options.even = p.even == "error"  ? EvenGrowth::Error
                 : p.even == "area" ? EvenGrowth::Area
                                    : EvenGrowth::Off;
  const bool evensOther = p.even == "area" || p.even == "off";
  if (depth_ == Depth::Whole && segmenterOf(p.method).balances && evensOther) {
    tell(Notice::Kind::Warning, "T-flooding evens out Gauss area, whatever \"Even out\" says.");
  }
  options.vsa = {vsaSeeding(p.vsaSeeding), p.vsaTeleport};
  options.mcgim = {p.mcgimLambda, p.mcgimNormals == "running", p.mcgimDisks};
  run_.onFlood = std::make_shared<std::function<void(const FloodBegun&)>>(
      [this](const FloodBegun& begun) { noteFlood(begun); });
  options.onFlood = [told = run_.onFlood](const FloodBegun& begun) { (*told)(begun); };
  const SegmentInputs inputs{mesh_, gauss_, graph_};
  run_.start.creases = creases;
  run_.stepper =
      creases ? makeCreaseStart(inputs, options) : segmenterOf(p.method).make(inputs, options);
  run_.timing.segment = 0;
  tellChartCount();
}

void Pipeline::keepFlood() {
  if (!run_.stepper || !run_.flood) return;
  const std::size_t rounds = run_.stepper->history().size();
  // A flood that was begun again ends as a new round.
  const std::size_t round = rounds > run_.roundsSeen ? rounds - 1 : run_.floodRound;
  run_.roundsSeen = rounds;
  if (round >= rounds || run_.flood->size() < run_.flood->capacity()) return;
  run_.floodRound = round;
  if (logs_ == FloodLogs::EveryRound)
    run_.floods.keep(round, run_.flood, run_.stepper->bestIteration());
}

void Pipeline::noteFlood(const FloodBegun& begun) {
  keepFlood();
  run_.flood = begun.record;
  run_.floodRound = begun.iteration;
  run_.start = begun.start;
  listener_.onFlood(begun);
}

StepOutcome Pipeline::step(StepUnit unit, std::size_t count, Progress& progress) {
  const Stopwatch stopwatch;
  // Who steps on from finished charts wants more rounds: these begin from the best one's seeds.
  if (!run_.stepper || finished() || overtaken_) {
    if (finished() && !standing()) run_.start = {};  // those are of other values
    progress.beginPhase("Placing seeds");
    const auto creases = wantsCreases();
    if (progress.cancelled()) return StepOutcome::Cancelled;
    makeStepper(static_cast<std::size_t>(document_.parameters.maxIterations), creases, wantsFast());
  } else if (run_.locksChanged) {
    takeLocks(progress);
  }
  const StepOutcome outcome = run_.stepper->advance(unit, count, progress);
  keepFlood();
  run_.timing.segment += stopwatch.milliseconds();
  if (outcome == StepOutcome::Finished && tellsOutcome_) tellOutcome();
  return outcome;
}

void Pipeline::restartFlood() {
  if (run_.stepper) run_.stepper->restartFlood();
}

void Pipeline::resetSeeds() {
  run_.start.seeds.clear();
  run_.start.offsets.clear();
  run_.start.normals.clear();
  if (run_.stepper) makeStepper(static_cast<std::size_t>(document_.parameters.maxIterations));
}

StepOutcome Pipeline::adopt(std::size_t iteration, Progress& progress) {
  if (!run_.stepper || iteration >= run_.stepper->history().size()) return StepOutcome::Advanced;
  const StepOutcome outcome = run_.stepper->adopt(iteration, progress);
  keepFlood();
  return outcome;
}

void Pipeline::recall(std::size_t iteration, Progress& progress) {
  if (!run_.stepper || iteration >= run_.stepper->history().size()) return;
  const auto kept = run_.floods.records();
  std::shared_ptr<const FloodRecord> record = iteration < kept.size() ? kept[iteration] : nullptr;
  if (!record) record = run_.stepper->replay(iteration, progress);
  if (record) run_.floods.recall(iteration, std::move(record));
}

}  // namespace chartflood
