#include "core/segment/t_flooding.h"

#include <algorithm>
#include <utility>

#include "core/base/rng.h"
#include "core/flood/build_flood_graph.h"
#include "core/flood/flood.h"
#include "core/segment/balance.h"
#include "core/segment/chart_areas.h"
#include "core/segment/convergence.h"
#include "core/segment/flood_rounds.h"
#include "core/segment/offsets.h"
#include "core/segment/seeds.h"

namespace chartflood {

namespace {

class TFlooding final : public FloodRounds {
 public:
  TFlooding(const SegmentInputs& inputs, const SegmentOptions& options)
      : FloodRounds("t-flooding", inputs, options),
        convergence_({options.maxIterations, options.patience, options.detectCycles,
                      options.useOffsets && options.offsetDamping > 0, options.settle}) {
    Rng rng(options.rngSeed);
    const std::size_t wanted = std::max(options.charts, options.seeds.size());
    seeds_ = placeSeeds(mesh(), effectiveChartCount(mesh(), wanted), options.seeds,
                        componentWeights(), rng);
    offsets_ = options.offsets;
    offsets_.resize(seeds_.size(), 0);
    flood_ = makeFlood(*inputs.floodGraph, seeds_.size());
    restartFlood();
  }

 private:
  FloodStart present() const override { return {nullptr, 0, seeds_, offsets_}; }
  void startFlood(std::shared_ptr<FloodRecord> record) override {
    flood_->start(seeds_, offsets_, options().lookahead, std::move(record));
  }
  std::size_t take(std::size_t count, Progress* progress) override {
    return flood_->advance(count, progress);
  }
  std::size_t taken() const override { return flood_->taken(); }
  std::vector<Index> labels() const override {
    std::vector<Index> label;
    flood_->copyLabels(label);
    return label;
  }
  const char* phaseName() const override { return "Flooding"; }
  bool floodAside(const IterationSummary& round, std::shared_ptr<FloodRecord> record,
                  Progress* progress) const override {
    const auto flood = makeFlood(*inputs().floodGraph, round.seeds.size());
    flood->start(round.seeds, round.offsets, options().lookahead, std::move(record));
    flood->advance(mesh().faceCount(), progress);
    return flood->finished();
  }

  IterationSummary measure() override {
    areas_ = chartAreas(mesh(), *inputs().gaussArea, faceGauss(), labels(), seeds_.size());
    balance_ = balanceOf(areas_.gaussArea);
    IterationSummary summary;
    summary.stdOverMean = balance_.stdOverMean();
    summary.balanceDefined = balance_.defined;
    return summary;
  }

  /// Sections 3.4 and 3.5.
  void planNext() override {
    nextSeeds_ = flood_->farthestFromBorder(seeds_);
    for (std::size_t c = 0; c < seeds_.size(); ++c) {
      if (options().isLocked(seeds_[c])) nextSeeds_[c] = seeds_[c];
    }
    nextOffsets_ = offsets_;
    if (options().useOffsets) {
      updateOffsets(nextOffsets_, areas_.gaussArea, options().offsetDamping);
    }
  }

  Judgement judge() override {
    planNext();
    const double badness = balance_.defined ? balance_.stdOverMean() : balance_.std;
    const bool settling = convergence_.settling();
    Judgement judgement;
    judgement.stop = convergence_.round(seeds_, nextSeeds_, badness);
    judgement.best = convergence_.best() + 1 == history().size();
    if (judgement.best) offsetsAfterBest_ = nextOffsets_;
    if (settling) {
      nextSeeds_ = seeds_;
    } else if (convergence_.settling()) {
      nextSeeds_ = history()[convergence_.best()].seeds;
      nextOffsets_ = offsetsAfterBest_;
    }
    return judgement;
  }

  std::size_t takeNext() override {
    std::size_t moved = 0;
    for (std::size_t c = 0; c < seeds_.size(); ++c) moved += seeds_[c] != nextSeeds_[c];
    seeds_ = nextSeeds_;
    offsets_ = nextOffsets_;
    return moved;
  }

  void standAt(const IterationSummary& round) override {
    seeds_ = round.seeds;
    offsets_ = round.offsets;
  }

  /// What each component has to share out among its charts: Gauss area and a little surface.
  std::vector<double> componentWeights() const {
    const auto component = mesh().faceComponent();
    std::vector<double> weight =
        chartAreas(mesh(), *inputs().gaussArea, faceGauss(), component, mesh().componentCount())
            .gaussArea;
    const std::vector<double> area = faceAreas(mesh());
    const double eta = inputs().floodGraph->eta;
    for (Index f = 0; f < area.size(); ++f) weight[component[f]] += eta * area[f];
    return weight;
  }

  std::unique_ptr<Flood> flood_;
  std::vector<Index> seeds_, nextSeeds_;
  std::vector<double> offsets_, nextOffsets_, offsetsAfterBest_;
  ChartAreas areas_;  ///< of the finished flood
  Balance balance_;
  Convergence convergence_;
};

}  // namespace

std::unique_ptr<Stepper> makeTFlooding(const SegmentInputs& inputs, const SegmentOptions& options) {
  return std::make_unique<TFlooding>(inputs, options);
}

}  // namespace chartflood
