#include "core/segment/t_flooding.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "core/base/check.h"
#include "core/base/rng.h"
#include "core/flood/build_flood_graph.h"
#include "core/flood/flood.h"
#include "core/gauss/compute_gauss_area.h"
#include "core/segment/balance.h"
#include "core/segment/border_refiner.h"
#include "core/segment/chart_areas.h"
#include "core/segment/convergence.h"
#include "core/segment/offsets.h"
#include "core/segment/seeds.h"

namespace chartflood {

namespace {

constexpr std::size_t kAll = std::numeric_limits<std::size_t>::max();

class TFlooding final : public Stepper {
 public:
  TFlooding(const SegmentInputs& inputs, const SegmentOptions& options)
      : in_(inputs), options_(options), faceGauss_(faceGaussArea(*in_.mesh, *in_.gaussArea)),
        convergence_({options.maxIterations, options.patience, options.detectCycles,
                      options.useOffsets && options.offsetDamping > 0, options.settle}) {
    Rng rng(options.rngSeed);
    const std::size_t wanted = std::max(options.charts, options.seeds.size());
    seeds_ = placeSeeds(*in_.mesh, effectiveChartCount(*in_.mesh, wanted), options.seeds,
                        componentWeights(), rng);
    offsets_ = options.offsets;
    offsets_.resize(seeds_.size(), 0);
    flood_ = makeFlood(*in_.floodGraph, seeds_.size());
    restartFlood();
  }

  StepOutcome advance(StepUnit unit, std::size_t count, Progress& progress) override {
    if (phase_ == Phase::Done) return StepOutcome::Finished;
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

  std::shared_ptr<const Segmentation> state() const override {
    auto state = std::make_shared<Segmentation>();
    state->method = "t-flooding";
    state->chartCount = seeds_.size();
    state->requestedCharts = options_.charts;
    state->seeds = seeds_;
    state->iteration = iteration_;
    if (phase_ == Phase::Done || phase_ == Phase::Refining) {
      state->label = finalLabel_;
      state->refined = phase_ == Phase::Done && options_.refine.kind != RefineKind::None;
      state->complete = true;
    } else {
      flood_->copyLabels(state->label);
      state->complete = flood_->finished();
    }
    state->areas = chartAreas(*in_.mesh, *in_.gaussArea, faceGauss_, state->label, seeds_.size());
    return state;
  }

  std::shared_ptr<const FloodRecord> record() const override { return record_; }
  std::shared_ptr<const SeamRecord> seamRecord() const override {
    return phase_ == Phase::Done ? seamRecord_ : nullptr;
  }
  std::span<const IterationSummary> history() const override { return history_; }
  std::size_t bestIteration() const override { return convergence_.best(); }
  StopReason stopReason() const override { return stopReason_; }
  bool finished() const override { return phase_ == Phase::Done; }

  StepOutcome adopt(std::size_t iteration, Progress& progress) override {
    CF_CHECK(iteration < history_.size());
    if (!floodAgain(iteration, progress)) return StepOutcome::Cancelled;
    phase_ = Phase::Flooded;
    stopReason_ = StopReason::NotStopped;
    planNextRound();
    return StepOutcome::Advanced;
  }

  void restartFlood() override {
    record_ = options_.record ? std::make_shared<FloodRecord>(in_.mesh->faceCount()) : nullptr;
    flood_->start(seeds_, offsets_, options_.lookahead, record_);
    phase_ = Phase::Flooding;
    stopReason_ = StopReason::NotStopped;
    refiner_.reset();
    if (options_.onFlood) options_.onFlood({record_, iteration_, seeds_, offsets_});
  }

 private:
  enum class Phase {
    Flooding,  ///< a flood is ready or under way
    Flooded,   ///< a round is done and judged, the next one planned
    Refining,  ///< the best round is chosen and its borders are being refined
    Done,
  };

  /// What each component has to share out among its charts: Gauss area and a little surface.
  std::vector<double> componentWeights() const {
    const Mesh& mesh = *in_.mesh;
    const auto component = mesh.faceComponent();
    std::vector<double> weight =
        chartAreas(mesh, *in_.gaussArea, faceGauss_, component, mesh.componentCount()).gaussArea;
    const std::vector<double> area = faceAreas(mesh);
    for (Index f = 0; f < area.size(); ++f) weight[component[f]] += in_.floodGraph->eta * area[f];
    return weight;
  }

  /// Repeats a step until it is done, cancelled, or everything is finished.
  template <class Step>
  StepOutcome repeat(std::size_t count, const Progress& progress, const Step& step) {
    for (std::size_t i = 0; i < count && phase_ != Phase::Done; ++i) {
      if (!step() || progress.cancelled()) return StepOutcome::Cancelled;
    }
    return phase_ == Phase::Done ? StepOutcome::Finished : StepOutcome::Advanced;
  }

  StepOutcome advanceFaces(std::size_t count, Progress& progress) {
    while (count > 0 && phase_ != Phase::Done) {
      if (!leaveFlooded(progress)) return StepOutcome::Cancelled;
      if (phase_ != Phase::Flooding) break;
      count -= flood_->advance(count, &progress);
      if (flood_->finished()) judgeRound();
      if (progress.cancelled()) return StepOutcome::Cancelled;
    }
    return phase_ == Phase::Done ? StepOutcome::Finished : StepOutcome::Advanced;
  }

  /// To the end of the flood under way, or of the next one. False when cancelled before.
  bool oneFlood(Progress& progress) {
    if (!leaveFlooded(progress)) return false;
    return phase_ == Phase::Done || completeFlood(progress);
  }

  bool oneIteration(Progress& progress) {
    const bool underWay = phase_ == Phase::Flooding && flood_->taken() > 0;
    if (underWay && !completeFlood(progress)) return false;
    return oneFlood(progress);
  }

  bool completeFlood(Progress& progress) {
    progress.beginPhase("Flooding");
    flood_->advance(kAll, &progress);
    if (!flood_->finished()) return false;
    judgeRound();
    return true;
  }

  /// After a finished round: begins the next one, or when a stop rule fired, finishes everything.
  bool leaveFlooded(Progress& progress) {
    if (phase_ == Phase::Flooded && stopReason_ == StopReason::NotStopped) beginNextRound();
    if (phase_ == Phase::Flooding) return true;
    return finish(progress);
  }

  void beginNextRound() {
    for (std::size_t c = 0; c < seeds_.size(); ++c) movedSeeds_ += seeds_[c] != nextSeeds_[c];
    seeds_ = nextSeeds_;
    offsets_ = nextOffsets_;
    iteration_ = history_.size();
    restartFlood();
  }

  /// Measures the balance of a finished flood and writes it into the history.
  void judgeRound() {
    planNextRound();
    IterationSummary summary;
    summary.iteration = history_.size();
    summary.stdOverMean = balance_.stdOverMean();
    summary.balanceDefined = balance_.defined;
    summary.movedSeeds = std::exchange(movedSeeds_, 0);
    summary.seeds = seeds_;
    summary.offsets = offsets_;
    history_.push_back(std::move(summary));
    iteration_ = history_.size() - 1;
    const double badness = balance_.defined ? balance_.stdOverMean() : balance_.std;
    const bool settling = convergence_.settling();
    stopReason_ = convergence_.round(seeds_, nextSeeds_, badness);
    if (convergence_.best() == iteration_) {
      bestLabel_ = label_;
      offsetsAfterBest_ = nextOffsets_;
    }
    if (settling) {
      nextSeeds_ = seeds_;
    } else if (convergence_.settling()) {
      nextSeeds_ = history_[convergence_.best()].seeds;
      nextOffsets_ = offsetsAfterBest_;
    }
    phase_ = Phase::Flooded;
  }

  /// Where the next round starts from the finished flood at hand (sections 3.4 and 3.5).
  void planNextRound() {
    flood_->copyLabels(label_);
    const ChartAreas areas =
        chartAreas(*in_.mesh, *in_.gaussArea, faceGauss_, label_, seeds_.size());
    balance_ = balanceOf(areas.gaussArea);
    nextSeeds_ = flood_->farthestFromBorder(seeds_);
    for (std::size_t c = 0; c < seeds_.size(); ++c) {
      const auto& locked = options_.locked;
      if (std::find(locked.begin(), locked.end(), seeds_[c]) != locked.end()) {
        nextSeeds_[c] = seeds_[c];
      }
    }
    nextOffsets_ = offsets_;
    if (options_.useOffsets) {
      updateOffsets(nextOffsets_, areas.gaussArea, options_.offsetDamping);
    }
  }

  /// Adopts the best round and refines its borders.
  bool finish(Progress& progress) {
    if (phase_ == Phase::Flooded) {
      const std::size_t best = convergence_.best();
      // The log of the present flood must be the one of the labels that are shown.
      if (record_ && best != iteration_ && !floodAgain(best, progress)) return false;
      seeds_ = history_[best].seeds;
      offsets_ = history_[best].offsets;
      iteration_ = best;
      finalLabel_ = bestLabel_;
      phase_ = Phase::Refining;
    }
    if (!refiner_) {
      refiner_ = std::make_unique<BorderRefiner>(in_, faceGauss_, finalLabel_, seeds_.size(),
                                                 seeds_, options_.refine);
    }
    if (!refiner_->run(progress)) return false;
    finalLabel_.assign(refiner_->labels().begin(), refiner_->labels().end());
    seamRecord_ = refiner_->record();
    refiner_.reset();
    phase_ = Phase::Done;
    return true;
  }

  /// Floods round `iteration` of the history again, which gives the same labels. When cancelled,
  /// the flood under way is that round's.
  bool floodAgain(std::size_t iteration, Progress& progress) {
    const StopReason reason = stopReason_;
    const Phase phase = phase_;
    seeds_ = history_[iteration].seeds;
    offsets_ = history_[iteration].offsets;
    iteration_ = iteration;
    restartFlood();
    flood_->advance(kAll, &progress);
    phase_ = phase;
    stopReason_ = reason;
    if (flood_->finished()) return true;
    iteration_ = history_.size();  // no finished round is shown
    return false;
  }

  SegmentInputs in_;
  SegmentOptions options_;
  std::vector<double> faceGauss_;
  std::unique_ptr<Flood> flood_;
  std::shared_ptr<FloodRecord> record_;
  Phase phase_ = Phase::Flooding;
  std::vector<Index> seeds_, nextSeeds_;
  std::vector<double> offsets_, nextOffsets_, offsetsAfterBest_;
  std::size_t iteration_ = 0;
  std::size_t movedSeeds_ = 0;
  std::vector<Index> label_, bestLabel_, finalLabel_;
  Balance balance_;
  std::vector<IterationSummary> history_;
  Convergence convergence_;
  StopReason stopReason_ = StopReason::NotStopped;
  std::unique_ptr<BorderRefiner> refiner_;
  std::shared_ptr<const SeamRecord> seamRecord_;
};

}  // namespace

std::unique_ptr<Stepper> makeTFlooding(const SegmentInputs& inputs, const SegmentOptions& options) {
  return std::make_unique<TFlooding>(inputs, options);
}

}  // namespace chartflood
