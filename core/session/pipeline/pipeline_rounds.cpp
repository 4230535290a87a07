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

}  // namespace

bool Pipeline::finished() const { return stepper_ != nullptr && stepper_->finished(); }

void Pipeline::takeLocks(Progress& progress) {
  const std::size_t taken = stepper_->record() ? stepper_->record()->size() : mesh_->faceCount();
  makeStepper(static_cast<std::size_t>(document_.parameters.maxIterations), wantsCreases(),
              start_.fast);
  if (taken > 0) stepper_->advance(StepUnit::Face, taken, progress);
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
  const bool wanted =
      p.search == "fast" || (p.search == "auto" && mesh_->faceCount() > kMostLiteralFaces);
  const bool fits = segmenterOf(p.method).knowsFast && wanted && !wantsCreases();
  return fits ? std::optional(FastFlood{}) : std::nullopt;
}

void Pipeline::makeStepper(std::size_t maxIterations) {
  makeStepper(maxIterations, wantsCreases(), wantsFast());
}

void Pipeline::makeStepper(std::size_t maxIterations, std::optional<std::uint32_t> creases,
                           const std::optional<FastFlood>& fast) {
  const Parameters& p = document_.parameters;
  SegmentOptions options;
  options.charts = wantedCharts();
  options.seeds = start_.seeds.empty() ? seedFaces(document_.seeds) : start_.seeds;
  options.locked = lockedFaces(document_.seeds);
  locksChanged_ = false;
  options.offsets = start_.offsets;
  options.normals = start_.normals;
  options.rngSeed = creases.value_or(static_cast<std::uint32_t>(p.rngSeed));
  options.creasesFirst = p.start == "creases";
  if (fast) {
    options.search = SearchKind::Fast;
    options.fast = *fast;
    if (!searchesFast(*mesh_, options)) tellTooSmall();
  }
  options.useOffsets = p.offsets;
  options.offsetDamping = p.offsetDamping;
  options.lookahead = p.lookahead;
  options.maxIterations = maxIterations;
  options.patience = static_cast<std::size_t>(p.patience);
  options.detectCycles = p.detectCycles;
  options.settle = static_cast<std::size_t>(p.settle);
  options.keepLast = p.keep == "last";
  options.record = logs_ != FloodLogs::None;
  options.refine = refineOptions(p);
  options.refine.sideFactor = hintFactors(*mesh_, document_.hints);
  options.vsa = {vsaSeeding(p.vsaSeeding), p.vsaTeleport};
  options.mcgim = {p.mcgimLambda, p.mcgimNormals == "running", p.mcgimDisks};
  seedRuns_.reset();
  onFlood_ = std::make_shared<std::function<void(const FloodBegun&)>>(
      [this](const FloodBegun& begun) { noteFlood(begun); });
  options.onFlood = [told = onFlood_](const FloodBegun& begun) { (*told)(begun); };
  stepper_.reset();
  flood_.reset();
  floods_.clear();
  roundsSeen_ = 0;
  const SegmentInputs inputs{mesh_, gauss_, graph_};
  start_.creases = creases;
  stepper_ =
      creases ? makeCreaseStart(inputs, options) : segmenterOf(p.method).make(inputs, options);
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
  if (logs_ == FloodLogs::EveryRound) floods_.keep(round, flood_, stepper_->bestIteration());
}

void Pipeline::noteFlood(const FloodBegun& begun) {
  keepFlood();
  flood_ = begun.record;
  floodRound_ = begun.iteration;
  start_ = begun.start;
  listener_.onFlood(begun);
}

StepOutcome Pipeline::step(StepUnit unit, std::size_t count, Progress& progress) {
  const Stopwatch stopwatch;
  found_.reset();
  // Who steps on from finished charts wants more rounds: these begin from the best one's seeds.
  if (!stepper_ || finished()) {
    progress.beginPhase("Placing seeds");
    const auto creases = wantsCreases();
    if (progress.cancelled()) return StepOutcome::Cancelled;
    makeStepper(static_cast<std::size_t>(document_.parameters.maxIterations), creases, wantsFast());
  } else if (locksChanged_) {
    takeLocks(progress);
  }
  const StepOutcome outcome = stepper_->advance(unit, count, progress);
  keepFlood();
  timing_.segment += stopwatch.milliseconds();
  if (outcome == StepOutcome::Finished) tellOutcome();
  return outcome;
}

void Pipeline::restartFlood() {
  if (stepper_) stepper_->restartFlood();
}

void Pipeline::resetSeeds() {
  start_.seeds.clear();
  start_.offsets.clear();
  start_.normals.clear();
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

}  // namespace chartflood
