#include "core/segment/creases/crease_start.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "core/base/check.h"
#include "core/gauss/compute_gauss_area.h"
#include "core/segment/borders/border_refiner.h"
#include "core/segment/creases/crease_regions.h"
#include "core/segment/creases/flat_regions.h"
#include "core/segment/creases/revolution.h"
#include "core/segment/parts/balance.h"
#include "core/segment/parts/chart_areas.h"
#include "core/segment/parts/part_shares.h"
#include "core/segment/parts/seeds.h"

namespace chartflood {

namespace {

constexpr double kBalanceShare = 0.01;
constexpr double kCreaseShare = 1.0 / 3;
constexpr double kDiagonal = 4;         // length of a quad's diagonal against its sides'
constexpr std::size_t kPublish = 1024;  // faces

/// Whether sharp edges divide the model by themselves.
bool followsCreases(const Mesh& mesh, const GaussArea& gauss) {
  return dividedByCreases(mesh, gauss) || ringsBetweenCreases(mesh, gauss);
}

class CreaseStart final : public Stepper {
 public:
  CreaseStart(const SegmentInputs& inputs, const SegmentOptions& options)
      : in_(inputs), options_(options), faceGauss_(faceGaussArea(*in_.mesh, *in_.gaussArea)) {
    const std::size_t charts = effectiveChartCount(*in_.mesh, options.charts);
    Rng rng(options.rngSeed);
    CreaseRegions regions = firstCharts(charts, rng);
    label_ = std::move(regions.label);
    seeds_ = startSeeds_ = middles(label_, regions.count);
    offsets_.assign(seeds_.size(), 0);
    planGrowth();
    restartFlood();
  }

  StepOutcome advance(StepUnit unit, std::size_t count, Progress& progress) override {
    if (phase_ == Phase::Done) return StepOutcome::Finished;
    if (phase_ == Phase::Growing) {
      const std::size_t left = order_.size() - taken_;
      take(unit == StepUnit::Face ? std::min(left, count) : left);
      const bool more = unit == StepUnit::Converged || (unit == StepUnit::Face && count > left) ||
                        (unit != StepUnit::Face && count > 1);
      if (progress.cancelled()) return StepOutcome::Cancelled;
      if (!more || phase_ == Phase::Growing) return StepOutcome::Advanced;
    }
    return refine(progress);
  }

  std::shared_ptr<const Segmentation> state() const override {
    auto state = std::make_shared<Segmentation>();
    state->method = "creases";
    state->chartCount = seeds_.size();
    state->requestedCharts = options_.charts;
    state->seeds = seeds_;
    state->complete = phase_ != Phase::Growing;
    state->refined = phase_ == Phase::Done && options_.refine.kind != RefineKind::None;
    state->label.assign(label_.size(), kNone);
    for (std::size_t i = 0; i < taken_; ++i) state->label[order_[i]] = label_[order_[i]];
    if (phase_ == Phase::Done) state->label = finalLabel_;
    state->areas = areasOf(state->label);
    return state;
  }

  std::shared_ptr<const FloodRecord> record() const override { return record_; }
  std::shared_ptr<const SeamRecord> seamRecord() const override {
    return phase_ == Phase::Done ? seamRecord_ : nullptr;
  }
  std::span<const IterationSummary> history() const override { return history_; }
  std::size_t bestIteration() const override { return 0; }
  StopReason stopReason() const override {
    return phase_ == Phase::Done ? StopReason::Converged : StopReason::NotStopped;
  }
  bool finished() const override { return phase_ == Phase::Done; }

  StepOutcome adopt(std::size_t iteration, Progress& progress) override {
    CF_CHECK(iteration < history_.size());
    restartFlood();
    take(order_.size());
    return progress.cancelled() ? StepOutcome::Cancelled : StepOutcome::Advanced;
  }

  /// There is one round, and its charts grow in the same order every time.
  std::shared_ptr<const FloodRecord> replay(std::size_t iteration, Progress& progress) override {
    CF_CHECK(iteration < history_.size());
    if (progress.cancelled()) return nullptr;
    auto record = std::make_shared<FloodRecord>(in_.mesh->faceCount());
    for (const Index f : order_) record->append(f, label_[f], static_cast<float>(step_[f]));
    record->publish();
    return record;
  }

  void restartFlood() override {
    record_ = options_.record ? std::make_shared<FloodRecord>(in_.mesh->faceCount()) : nullptr;
    taken_ = 0;
    phase_ = Phase::Growing;
    refiner_.reset();
    seeds_ = startSeeds_;
    tellSeeds();
  }

 private:
  enum class Phase { Growing, Grown, Done };

  /// Charts before their borders are refined.
  CreaseRegions firstCharts(std::size_t charts, Rng& rng) {
    const Mesh& mesh = *in_.mesh;
    const GaussArea& gauss = *in_.gaussArea;
    const PartShares shares =
        partShares(mesh, gauss, faceGauss_, in_.floodGraph->eta, options_.charts);
    std::optional<FlatParts> flat = flatParts(mesh, charts);
    const bool planes = flat && (flat->regions.count <= charts || !followsCreases(mesh, gauss));
    CreaseRegions regions = planes ? std::move(flat->regions) : creaseRegions(mesh, gauss);
    const bool joined = regions.count >= charts;
    if (flat && !options_.refine.sideFactor && joined) options_.refine.kind = RefineKind::None;
    if (flat && !joined) holdQuads(flat->partner);
    CreaseRules rules{.most = shares.most, .first = options_.creasesFirst};
    if (flat) rules.partner = flat->partner;
    return chartsFromCreases(mesh, gauss, faceGauss_, std::move(regions), charts, rng, rules);
  }

  /// Makes the diagonals of quads dearer than the way around them.
  void holdQuads(std::span<const Index> partner) {
    const Mesh& mesh = *in_.mesh;
    auto factor = options_.refine.sideFactor
                      ? std::make_shared<std::vector<double>>(*options_.refine.sideFactor)
                      : std::make_shared<std::vector<double>>(mesh.opposite().size(), 1.0);
    for (Index s = 0; s < factor->size(); ++s) {
      if (mesh.opposite()[s] == kNone) continue;
      if (partner[mesh.faceOf(s / 3)] == mesh.faceOf(mesh.opposite()[s] / 3)) {
        (*factor)[s] *= kDiagonal;
      }
    }
    options_.refine.sideFactor = std::move(factor);
  }

  void tellSeeds() const {
    if (options_.onFlood)
      options_.onFlood({record_, 0, {seeds_, offsets_, {}, options_.rngSeed, {}}});
  }

  ChartAreas areasOf(std::span<const Index> label) const {
    return chartAreas(*in_.mesh, *in_.gaussArea, faceGauss_, label, seeds_.size());
  }

  template <class Visit>
  void forNeighbours(Index f, const Visit& visit) const {
    const Mesh& mesh = *in_.mesh;
    for (Index s = 3 * mesh.triangleBegin(f); s < 3 * mesh.triangleBegin(f + 1); ++s) {
      const Index other = mesh.opposite()[s];
      visit(other == kNone ? kNone : mesh.faceOf(other / 3));
    }
  }

  /// Of each chart the face most steps away from the chart's border.
  std::vector<Index> middles(std::span<const Index> label, std::size_t charts) const {
    std::vector<Index> middle(charts, kNone);
    std::vector<Index> queue, depth(label.size(), kNone);
    for (Index f = 0; f < label.size(); ++f) {
      bool border = false;
      forNeighbours(f, [&](Index g) { border = border || g == kNone || label[g] != label[f]; });
      if (border) depth[f] = 0;
      if (border) queue.push_back(f);
    }
    for (std::size_t i = 0; i < queue.size(); ++i) {
      forNeighbours(queue[i], [&](Index g) {
        if (g == kNone || depth[g] != kNone) return;
        depth[g] = depth[queue[i]] + 1;
        queue.push_back(g);
      });
    }
    for (Index f = 0; f < label.size(); ++f) {
      Index& best = middle[label[f]];
      if (best == kNone || (depth[f] != kNone && depth[f] > depth[best])) best = f;
    }
    return middle;
  }

  /// The order in which the charts are shown to grow: breadth-first, all at the same time.
  void planGrowth() {
    order_ = startSeeds_;
    order_.reserve(label_.size());
    step_.assign(label_.size(), kNone);
    for (const Index seed : startSeeds_) step_[seed] = 0;
    for (std::size_t i = 0; i < order_.size(); ++i) {
      const Index f = order_[i];
      forNeighbours(f, [&](Index g) {
        if (g == kNone || step_[g] != kNone || label_[g] != label_[f]) return;
        step_[g] = step_[f] + 1;
        order_.push_back(g);
      });
    }
    CF_CHECK(order_.size() == label_.size());
  }

  void take(std::size_t count) {
    for (std::size_t i = 0; i < count; ++i, ++taken_) {
      if (!record_) continue;
      const Index f = order_[taken_];
      record_->append(f, label_[f], static_cast<float>(step_[f]));
      if (i % kPublish == kPublish - 1) record_->publish();
    }
    if (record_) record_->publish();
    if (taken_ < order_.size()) return;
    phase_ = Phase::Grown;
    if (!history_.empty()) return;
    const Balance balance = balanceOf(areasOf(label_).gaussArea);
    IterationSummary round;
    round.stdOverMean = balance.stdOverMean();
    round.balanceDefined = balance.defined;
    round.seeds = seeds_;
    round.offsets = offsets_;
    history_.push_back(std::move(round));
  }

  StepOutcome refine(Progress& progress) {
    if (!refiner_) {
      RefineOptions refine = options_.refine;
      refine.oneSided = true;
      refine.balanceWeight *= kBalanceShare;
      refine.creaseWeight *= kCreaseShare;
      refine.cleanUp = 0;  // single faces know no one-sided balance
      refiner_ = std::make_unique<BorderRefiner>(in_, faceGauss_, label_, seeds_.size(),
                                                 std::vector<Index>(), refine);
    }
    if (!refiner_->run(progress)) return StepOutcome::Cancelled;
    finalLabel_.assign(refiner_->labels().begin(), refiner_->labels().end());
    seamRecord_ = refiner_->record();
    refiner_.reset();
    phase_ = Phase::Done;
    seeds_ = middles(finalLabel_, seeds_.size());
    tellSeeds();
    return StepOutcome::Finished;
  }

  SegmentInputs in_;
  SegmentOptions options_;
  FaceValues faceGauss_;
  std::vector<Index> label_, finalLabel_;
  std::vector<Index> seeds_, startSeeds_;  ///< middles of the present charts, of those at first
  std::vector<double> offsets_;            ///< none waits
  std::vector<Index> order_, step_;        ///< faces as they are shown, and steps from their seed
  std::size_t taken_ = 0;
  Phase phase_ = Phase::Growing;
  std::shared_ptr<FloodRecord> record_;
  std::vector<IterationSummary> history_;
  std::unique_ptr<BorderRefiner> refiner_;
  std::shared_ptr<const SeamRecord> seamRecord_;
};

}  // namespace

std::unique_ptr<Stepper> makeCreaseStart(const SegmentInputs& inputs,
                                         const SegmentOptions& options) {
  return std::make_unique<CreaseStart>(inputs, options);
}

bool suitsCreaseStart(const SegmentInputs& inputs, std::size_t charts) {
  return hasFlatParts(*inputs.mesh, effectiveChartCount(*inputs.mesh, charts)) ||
         followsCreases(*inputs.mesh, *inputs.gaussArea);
}

}  // namespace chartflood
