#include "core/segment/growth/growth_rounds.h"

#include <algorithm>
#include <optional>
#include <utility>

#include <glm/geometric.hpp>

#include "core/base/rng.h"
#include "core/segment/parts/balance.h"
#include "core/segment/parts/chart_areas.h"
#include "core/segment/parts/seeds.h"
#include "core/segment/rounds/convergence.h"
#include "core/segment/rounds/flood_rounds.h"
#include "core/segment/rounds/offsets.h"

namespace chartflood {

namespace {

/// These methods know no balance: borders are refined by their length and the method's own cost.
SegmentOptions withoutBalance(SegmentOptions options) {
  options.refine.balanceWeight = options.refine.cleanUp = 0;
  return options;
}

class GrowthRounds final : public FloodRounds {
 public:
  GrowthRounds(const char* id, const SegmentInputs& inputs, const SegmentOptions& options,
               std::unique_ptr<GrowthMethod> method, const GrowthStart& first,
               std::size_t chartCount)
      : FloodRounds(id, inputs, withoutBalance(options)), chartCount_(chartCount),
        method_(std::move(method)), start_(first),
        convergence_({options.maxIterations, options.patience, false, true, options.settle}) {
    restartFlood();
  }

 private:
  FloodStart present() const override {
    return {start_.seeds, start_.offsets, start_.normals, {}, {}};
  }
  void startFlood(std::shared_ptr<FloodRecord> record) override {
    method_->start(start_, std::move(record));
  }
  std::size_t take(std::size_t count, Progress* progress) override {
    return method_->advance(count, progress);
  }
  std::size_t taken() const override { return method_->taken(); }
  std::vector<Index> labels() const override {
    const std::vector<GrowthFace>& faces = method_->faces();
    std::vector<Index> label(faces.size());
    for (std::size_t f = 0; f < faces.size(); ++f) label[f] = faces[f].label;
    return label;
  }
  const char* phaseName() const override { return "Growing charts"; }
  bool floodAside(const IterationSummary& round, std::shared_ptr<FloodRecord> record,
                  Progress* progress) const override {
    return method_->floodAside({round.seeds, round.normals, round.offsets}, std::move(record),
                               progress);
  }

  IterationSummary measure() override {
    cost_ = method_->measure(start_);
    const Balance balance = balanceOf(
        chartAreas(mesh(), *inputs().gaussArea, faceGauss(), labels(), start_.seeds.size())
            .gaussArea);
    IterationSummary summary;
    summary.stdOverMean = balance.stdOverMean();
    summary.balanceDefined = balance.defined;
    summary.cost = cost_;
    return summary;
  }

  void planNext() override {
    next_ = method_->relaxed();
    if (start_.offsets.empty()) return;
    next_.offsets = start_.offsets;
    updateOffsets(next_.offsets, errors(), kEvenDamping);
  }

  /// Of each chart of the finished flood, what is to be even.
  std::vector<double> errors() const {
    if (options().even != EvenGrowth::Area) return method_->chartCosts();
    std::vector<double> area(start_.seeds.size(), 0);
    for (const GrowthFace& face : method_->faces()) {
      area[face.label] += static_cast<double>(face.area);
    }
    return area;
  }

  /// Of a round of even growth.
  Judgement judgeEven() {
    planNext();
    const Balance balance = balanceOf(errors());
    const double badness = balance.defined ? balance.stdOverMean() : balance.std;
    const bool settling = convergence_.settling();
    const StopReason stop = convergence_.round(start_.seeds, next_.seeds, badness);
    const bool best = convergence_.best() + 1 == convergence_.rounds();
    if (best) {
      bestStart_ = start_;
      bestStart_.offsets = next_.offsets;
    }
    if (settling) {
      std::vector<double> offsets = std::move(next_.offsets);
      next_ = start_;
      next_.offsets = std::move(offsets);
    } else if (convergence_.settling()) {
      next_ = bestStart_;
    }
    return {stop, best};
  }

  Judgement judge() override {
    if (!start_.offsets.empty()) return judgeEven();
    Judgement judgement = judgeAlone();
    if (judgement.best) bestStart_ = start_;
    if (judgement.stop == StopReason::NotStopped || options().even == EvenGrowth::Off) {
      return judgement;
    }
    // The method is done: its best round is where even growth begins.
    next_ = bestStart_;
    next_.offsets.assign(next_.seeds.size(), 0);
    judgement.stop = StopReason::NotStopped;
    return judgement;
  }

  /// Of a round as the method's paper has it.
  Judgement judgeAlone() {
    GrowthMethod::Verdict verdict = method_->judge();
    next_ = std::move(verdict.next);
    Judgement judgement{verdict.stop, false};
    if (start_.seeds.size() < chartCount_) return judgement;
    judgement.best = !least_ || cost_ < *least_;
    if (judgement.best) least_ = cost_;
    if (++fullRounds_ >= options().maxIterations && judgement.stop == StopReason::NotStopped) {
      judgement.stop = StopReason::MaxIterations;
    }
    return judgement;
  }

  std::optional<std::size_t> takeNext(Progress&) override {
    std::size_t moved = 0;
    for (std::size_t c = 0; c < next_.seeds.size(); ++c) {
      moved += c >= start_.seeds.size() || start_.seeds[c] != next_.seeds[c];
    }
    start_ = std::move(next_);
    return moved;
  }

  std::shared_ptr<ChartPrice> price() const override { return method_->price(start_); }

  void standAt(const IterationSummary& round) override {
    start_ = {round.seeds, round.normals, round.offsets};
  }

  static constexpr double kEvenDamping = 0.3;

  std::size_t chartCount_;
  std::unique_ptr<GrowthMethod> method_;
  GrowthStart start_, next_;
  double cost_ = 0;              ///< of the finished flood
  std::optional<double> least_;  ///< of the rounds with all charts
  std::size_t fullRounds_ = 0;   ///< rounds with all charts
  Convergence convergence_;      ///< of even growth
  GrowthStart bestStart_;        ///< of the best round; in even growth with the offsets after it
};

glm::dvec3 faceNormal(const Mesh& mesh, Index face) {
  const glm::dvec3 vector = areaVector(mesh, face);
  const double length = glm::length(vector);
  return length > 0 ? vector / length : vector;
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
  // Offsets that come with normals are a round of before, which was even.
  const bool even = options.even != EvenGrowth::Off && !options.normals.empty();
  if (even && options.offsets.size() == start.seeds.size()) start.offsets = options.offsets;
  return start;
}

}  // namespace chartflood
