#include "core/segment/growth_rounds.h"

#include <algorithm>
#include <limits>
#include <utility>

#include <glm/geometric.hpp>

#include "core/base/check.h"
#include "core/base/rng.h"
#include "core/gauss/compute_gauss_area.h"
#include "core/segment/balance.h"
#include "core/segment/border_refiner.h"
#include "core/segment/chart_areas.h"
#include "core/segment/seeds.h"

namespace chartflood {

namespace {

constexpr std::size_t kAll = std::numeric_limits<std::size_t>::max();

class GrowthRounds final : public Stepper {
 public:
  GrowthRounds(const char* id, const SegmentInputs& inputs, const SegmentOptions& options,
               std::unique_ptr<GrowthMethod> method, const GrowthStart& first,
               std::size_t chartCount)
      : id_(id), in_(inputs), options_(options), chartCount_(chartCount),
        faceGauss_(faceGaussArea(*in_.mesh, *in_.gaussArea)), method_(std::move(method)),
        start_(first) {
    options_.refine.balanceWeight = options_.refine.cleanUp = 0;
    restartFlood();
  }

  StepOutcome advance(StepUnit unit, std::size_t count, Progress& progress) override {
    if (phase_ == Phase::Done) return StepOutcome::Finished;
    if (unit == StepUnit::Face) return advanceFaces(count, progress);
    if (unit == StepUnit::Converged) count = kAll;
    for (std::size_t i = 0; i < count && phase_ != Phase::Done; ++i) {
      const bool done = unit == StepUnit::Iteration ? oneIteration(progress) : oneFlood(progress);
      if (!done || progress.cancelled()) return StepOutcome::Cancelled;
    }
    return phase_ == Phase::Done ? StepOutcome::Finished : StepOutcome::Advanced;
  }

  std::shared_ptr<const Segmentation> state() const override {
    auto state = std::make_shared<Segmentation>();
    state->method = id_;
    state->chartCount = start_.seeds.size();
    state->requestedCharts = options_.charts;
    state->seeds = start_.seeds;
    state->iteration = iteration_;
    if (phase_ == Phase::Done || phase_ == Phase::Refining) {
      state->label = finalLabel_;
      state->refined = phase_ == Phase::Done && options_.refine.kind != RefineKind::None;
      state->complete = true;
    } else {
      state->label = labels();
      state->complete = method_->finished();
    }
    state->areas =
        chartAreas(*in_.mesh, *in_.gaussArea, faceGauss_, state->label, state->chartCount);
    return state;
  }

  std::shared_ptr<const FloodRecord> record() const override { return record_; }
  std::shared_ptr<const SeamRecord> seamRecord() const override {
    return phase_ == Phase::Done ? seamRecord_ : nullptr;
  }
  std::span<const IterationSummary> history() const override { return history_; }
  std::size_t bestIteration() const override { return best_; }
  StopReason stopReason() const override { return stopReason_; }
  bool finished() const override { return phase_ == Phase::Done; }

  StepOutcome adopt(std::size_t iteration, Progress& progress) override {
    CF_CHECK(iteration < history_.size());
    if (!floodAgain(iteration, progress)) return StepOutcome::Cancelled;
    phase_ = Phase::Flooded;
    stopReason_ = StopReason::NotStopped;
    method_->measure(start_);
    next_ = method_->relaxed();
    return StepOutcome::Advanced;
  }

  void restartFlood() override {
    record_ = options_.record ? std::make_shared<FloodRecord>(in_.mesh->faceCount()) : nullptr;
    method_->start(start_, record_);
    phase_ = Phase::Flooding;
    stopReason_ = StopReason::NotStopped;
    refiner_.reset();
    if (options_.onFlood) {
      options_.onFlood({record_, iteration_, start_.seeds, {}, start_.normals});
    }
  }

 private:
  enum class Phase {
    Flooding,  ///< a flood is ready or under way
    Flooded,   ///< a round is done and judged, the next one planned
    Refining,  ///< the best round is chosen and its borders are being refined
    Done,
  };

  StepOutcome advanceFaces(std::size_t count, Progress& progress) {
    while (count > 0 && phase_ != Phase::Done) {
      if (!leaveFlooded(progress)) return StepOutcome::Cancelled;
      if (phase_ != Phase::Flooding) break;
      count -= method_->advance(count, &progress);
      if (method_->finished()) judgeRound();
      if (progress.cancelled()) return StepOutcome::Cancelled;
    }
    return phase_ == Phase::Done ? StepOutcome::Finished : StepOutcome::Advanced;
  }

  bool oneFlood(Progress& progress) {
    if (!leaveFlooded(progress)) return false;
    return phase_ == Phase::Done || completeFlood(progress);
  }

  bool oneIteration(Progress& progress) {
    const bool underWay = phase_ == Phase::Flooding && method_->taken() > 0;
    if (underWay && !completeFlood(progress)) return false;
    return oneFlood(progress);
  }

  bool completeFlood(Progress& progress) {
    progress.beginPhase("Growing charts");
    method_->advance(kAll, &progress);
    if (!method_->finished()) return false;
    judgeRound();
    return true;
  }

  /// After a finished round: begins the next one, or when a stop rule fired, finishes everything.
  bool leaveFlooded(Progress& progress) {
    if (phase_ == Phase::Flooded && stopReason_ == StopReason::NotStopped) {
      movedSeeds_ = 0;
      for (std::size_t c = 0; c < next_.seeds.size(); ++c) {
        movedSeeds_ += c >= start_.seeds.size() || start_.seeds[c] != next_.seeds[c];
      }
      start_ = std::move(next_);
      iteration_ = history_.size();
      restartFlood();
    }
    return phase_ == Phase::Flooding || finish(progress);
  }

  std::vector<Index> labels() const {
    const std::vector<GrowthFace>& faces = method_->faces();
    std::vector<Index> label(faces.size());
    for (std::size_t f = 0; f < faces.size(); ++f) label[f] = faces[f].label;
    return label;
  }

  /// Measures a finished flood, writes it into the history and plans what comes next.
  void judgeRound() {
    IterationSummary summary;
    const bool allCharts = start_.seeds.size() == chartCount_;
    const double cost = method_->measure(start_);
    std::vector<Index> label = labels();
    const Balance balance = balanceOf(
        chartAreas(*in_.mesh, *in_.gaussArea, faceGauss_, label, start_.seeds.size()).gaussArea);
    summary.iteration = iteration_ = history_.size();
    summary.stdOverMean = balance.stdOverMean();
    summary.balanceDefined = balance.defined;
    summary.movedSeeds = std::exchange(movedSeeds_, 0);
    summary.seeds = start_.seeds;
    summary.normals = start_.normals;
    summary.cost = cost;
    history_.push_back(std::move(summary));
    GrowthMethod::Verdict verdict = method_->judge();
    next_ = std::move(verdict.next);
    stopReason_ = verdict.stop;
    phase_ = Phase::Flooded;
    if (!allCharts) return;
    if (bestLabel_.empty() || cost < history_[best_].cost) {
      best_ = iteration_;
      bestLabel_ = std::move(label);
    }
    if (++fullRounds_ >= options_.maxIterations && stopReason_ == StopReason::NotStopped) {
      stopReason_ = StopReason::MaxIterations;
    }
  }

  /// Adopts the best round and refines its borders.
  bool finish(Progress& progress) {
    if (phase_ == Phase::Flooded) {
      // The log of the present flood must be the one of the labels that are shown.
      if (record_ && best_ != iteration_ && !floodAgain(best_, progress)) return false;
      start_ = {history_[best_].seeds, history_[best_].normals};
      iteration_ = best_;
      finalLabel_ = bestLabel_;
      phase_ = Phase::Refining;
    }
    if (!refiner_) {
      refiner_ = std::make_unique<BorderRefiner>(in_, faceGauss_, finalLabel_, start_.seeds.size(),
                                                 start_.seeds, options_.refine);
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
    start_ = {history_[iteration].seeds, history_[iteration].normals};
    iteration_ = iteration;
    restartFlood();
    method_->advance(kAll, &progress);
    phase_ = phase;
    stopReason_ = reason;
    if (method_->finished()) return true;
    iteration_ = history_.size();  // no finished round is shown
    return false;
  }

  const char* id_;
  SegmentInputs in_;
  SegmentOptions options_;
  std::size_t chartCount_;
  std::vector<double> faceGauss_;
  std::unique_ptr<GrowthMethod> method_;
  std::shared_ptr<FloodRecord> record_;
  Phase phase_ = Phase::Flooding;
  GrowthStart start_, next_;
  std::size_t iteration_ = 0, best_ = 0;
  std::size_t movedSeeds_ = 0;
  std::size_t fullRounds_ = 0;  ///< rounds with all charts
  std::vector<Index> bestLabel_, finalLabel_;
  std::vector<IterationSummary> history_;
  StopReason stopReason_ = StopReason::NotStopped;
  std::unique_ptr<BorderRefiner> refiner_;
  std::shared_ptr<const SeamRecord> seamRecord_;
};

glm::dvec3 faceNormal(const Mesh& mesh, Index face) {
  glm::dvec3 normal{0};
  for (Index t = mesh.triangleBegin(face); t < mesh.triangleBegin(face + 1); ++t) {
    if (mesh.degenerate(t)) continue;
    const auto& corner = mesh.triangles()[t];
    const glm::dvec3 a = mesh.positions()[corner[0]];
    normal += glm::cross(mesh.positions()[corner[1]] - a, mesh.positions()[corner[2]] - a);
  }
  const double length = glm::length(normal);
  return length > 0 ? normal / length : normal;
}

}  // namespace

std::unique_ptr<Stepper> makeGrowthRounds(const char* id, const SegmentInputs& inputs,
                                          const SegmentOptions& options,
                                          std::unique_ptr<GrowthMethod> method,
                                          const GrowthStart& first, std::size_t chartCount) {
  return std::make_unique<GrowthRounds>(id, inputs, options, std::move(method), first, chartCount);
}

GrowthStart firstGrowthStart(const SegmentInputs& inputs, const SegmentOptions& options) {
  const Mesh& mesh = *inputs.mesh;
  Rng rng(options.rngSeed);
  GrowthStart start;
  // Just the given seeds, or the first, and one in each bare component.
  start.seeds = placeSeeds(mesh, 0, options.seeds, {}, rng);
  if (options.normals.size() == options.seeds.size()) start.normals = options.normals;
  for (std::size_t c = start.normals.size(); c < start.seeds.size(); ++c) {
    start.normals.push_back(faceNormal(mesh, start.seeds[c]));
  }
  return start;
}

std::size_t seedsToAdd(std::size_t present, std::size_t wanted) {
  return std::min(wanted - present, std::max<std::size_t>(1, present / 32));
}

}  // namespace chartflood
