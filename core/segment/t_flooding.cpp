#include "core/segment/t_flooding.h"

#include <algorithm>
#include <utility>

#include "core/base/rng.h"
#include "core/flood/flood.h"
#include "core/segment/fast/fast_flooding.h"
#include "core/segment/parts/balance.h"
#include "core/segment/parts/chart_areas.h"
#include "core/segment/parts/seeds.h"
#include "core/segment/rounds/flood_rounds.h"
#include "core/segment/rounds/round_plan.h"

namespace chartflood {

namespace {

class TFlooding final : public FloodRounds {
 public:
  TFlooding(const SegmentInputs& inputs, const SegmentOptions& options)
      : FloodRounds("t-flooding", inputs, options), rng_(options.rngSeed), locked_(options.locked) {
    charts_ = effectiveChartCount(mesh(), options.charts, options.seeds.size());
    shares_ =
        partShares(mesh(), *inputs.gaussArea, faceGauss(), inputs.floodGraph->eta, options.charts);
    // One by one: those given, or the first, and one in each bare component.
    const std::size_t first = options.placement == SeedPlacement::Spread ? charts_ : 0;
    plan_ = RoundPlan(options, options.maxIterations,
                      placeSeeds(mesh(), first, options.seeds, shares_, rng_), options.offsets);
    std::sort(locked_.begin(), locked_.end());
    restartFlood();
  }

 private:
  FloodStart present() const override { return {plan_.seeds(), plan_.offsets(), {}, {}, {}}; }
  void startFlood(std::shared_ptr<FloodRecord> record) override {
    if (!flood_) flood_ = makeFlood(*inputs().floodGraph, charts_);
    flood_->start(plan_.seeds(), plan_.offsets(), options().lookahead, std::move(record));
  }
  std::size_t take(std::size_t count, Progress* progress) override {
    return flood_->advance(count, progress);
  }
  std::size_t taken() const override { return flood_ ? flood_->taken() : mesh().faceCount(); }
  std::vector<Index> labels() const override {
    std::vector<Index> label;
    flood_->copyLabels(label);
    return label;
  }
  void rest() override { flood_.reset(); }
  const char* phaseName() const override { return "Flooding"; }
  bool floodAside(const IterationSummary& round, std::shared_ptr<FloodRecord> record,
                  Progress* progress) const override {
    const auto flood = makeFlood(*inputs().floodGraph, round.seeds.size());
    flood->start(round.seeds, round.offsets, options().lookahead, std::move(record));
    flood->advance(mesh().faceCount(), progress);
    return flood->finished();
  }

  IterationSummary measure() override {
    areas_ = chartAreas(mesh(), *inputs().gaussArea, faceGauss(), labels(), plan_.seeds().size());
    balance_ = balanceOf(areas_.gaussArea);
    IterationSummary summary;
    summary.stdOverMean = balance_.stdOverMean();
    summary.balanceDefined = balance_.defined;
    return summary;
  }

  void planNext() override {
    plan_.plan(*flood_, areas_.gaussArea, locked_);
    if (!placing()) return;
    const std::size_t present = plan_.seeds().size();
    const std::size_t count = present + seedsToAdd(present, charts_);
    plan_.planMore(placeSeeds(mesh(), count, plan_.nextSeeds(), shares_, rng_));
  }

  /// Rounds on the way to all seeds are neither the best nor the last.
  bool placing() const { return plan_.seeds().size() < charts_; }

  double badness() const {
    if (options().roundMeasure == RoundMeasure::Printed) return balance_.stdEq3;
    return balance_.defined ? balance_.stdOverMean() : balance_.std;
  }

  Judgement judge() override {
    planNext();
    if (placing()) return {};
    const StopReason stop = plan_.judge(badness());
    return {stop, plan_.newBest()};
  }

  std::optional<std::size_t> takeNext(Progress&) override { return plan_.takeNext(); }

  void standAt(const IterationSummary& round) override {
    plan_.standAt(round.seeds, round.offsets);
  }

  Rng rng_;
  std::size_t charts_ = 0;  ///< K in force; less are flooded while seeds come one by one
  PartShares shares_;
  RoundPlan plan_;
  std::unique_ptr<Flood> flood_;
  std::vector<Index> locked_;
  ChartAreas areas_;  ///< of the finished flood
  Balance balance_;
};

}  // namespace

std::unique_ptr<Stepper> makeTFlooding(const SegmentInputs& inputs, const SegmentOptions& options) {
  if (searchesFast(*inputs.mesh, options)) return makeFastFlooding(inputs, options);
  return std::make_unique<TFlooding>(inputs, options);
}

}  // namespace chartflood
