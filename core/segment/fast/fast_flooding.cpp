#include "core/segment/fast/fast_flooding.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <future>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "core/base/check.h"
#include "core/base/parallel.h"
#include "core/base/rng.h"
#include "core/segment/fast/coarse_graph.h"
#include "core/segment/fast/node_flood.h"
#include "core/segment/fast/seam_band.h"
#include "core/segment/parts/balance.h"
#include "core/segment/parts/seeds.h"
#include "core/segment/rounds/flood_rounds.h"
#include "core/segment/rounds/offset_steps.h"
#include "core/segment/rounds/round_plan.h"

namespace chartflood {

namespace {

constexpr std::size_t kAllFaces = std::numeric_limits<std::size_t>::max();
// S is sqrt(n) std / mean.
constexpr double kUnevenCoarse = 0.1;   // S that other seeds may better: a band cannot absorb it
constexpr double kEvenBand = 0.02;      // S that is good enough
constexpr std::size_t kBandRounds = 5;  // at most
constexpr std::size_t kBandPatience = 3;
constexpr std::size_t kWideCluster = 64;  // faces: one such on each side of a seam is enough
constexpr std::uint32_t kSeedStep = 0x9e3779b9u;  // to the generator seed of the other start

/// Clusters that the band takes in on each side of a seam.
std::size_t bandRings(std::size_t faces, std::size_t clusters) {
  return faces < kWideCluster * clusters ? 2 : 1;
}

/// Rounds of clusters without gain: the band evens out what more of them would.
std::size_t coarsePatience(std::size_t patience) { return (7 * patience + 9) / 10; }

std::size_t bandRoundsOf(std::size_t maxIterations) {
  return std::clamp<std::size_t>(maxIterations / 4, 1, kBandRounds);
}

/// How uneven charts are, comparable between rounds.
double badnessOf(const Balance& balance) {
  return balance.defined ? balance.stdOverMean() : balance.std;
}

/// A round of clusters: nodes that were seeds, and what came of it.
struct CoarseRound {
  double badness = std::numeric_limits<double>::infinity();
  std::vector<Index> seeds;
  std::vector<double> offsets;
};

/// A run of clusters from other seeds, on a thread of its own: that rounds from the given ones
/// leave charts too uneven is the rule, and they leave the other processors alone.
class OtherStart {
 public:
  explicit OtherStart(std::function<CoarseRound(Progress&)> run)
      : found_(std::async(std::launch::async,
                          [this, run = std::move(run)] { return run(progress_); })) {}
  ~OtherStart() { progress_.cancel(); }
  OtherStart(const OtherStart&) = delete;
  OtherStart& operator=(const OtherStart&) = delete;

  /// Its best round, once; nothing when `waiting` is cancelled before it is known.
  std::optional<CoarseRound> take(const Progress& waiting) {
    constexpr std::chrono::milliseconds kLook{5};
    while (found_.wait_for(kLook) != std::future_status::ready) {
      if (waiting.cancelled()) return std::nullopt;
    }
    return found_.get();
  }

 private:
  Progress progress_;
  std::future<CoarseRound> found_;  ///< goes first: waits for the thread
};

/// The seams of a coarse round and the band around them.
struct BandBase {
  std::vector<Index> seeds;  ///< nodes of the coarse round
  std::vector<double> offsets;
  SeamBand band;
};

class FastFlooding final : public FloodRounds {
 public:
  FastFlooding(const SegmentInputs& inputs, const SegmentOptions& options)
      : FloodRounds("t-flooding", inputs, options) {
    checkSeeds(mesh(), options.seeds);
    const std::size_t charts = effectiveChartCount(mesh(), options.charts, options.seeds.size());
    shares_ =
        partShares(mesh(), *inputs.gaussArea, faceGauss(), inputs.floodGraph->eta, options.charts);
    fast_ = options.fast;
    coarse_ = makeCoarseGraph(source(), clustersWith(options.seeds, charts));
    const std::vector<Index> given = nodesOf(options.seeds);
    for (const Index face : options.seeds) {
      if (options.isLocked(face)) locked_.push_back(nodeOf(face));
    }
    std::sort(locked_.begin(), locked_.end());
    Rng rng(options.rngSeed);
    plan_ =
        planFrom(placeCoarseSeeds(coarse_, mesh().componentCount(), charts, given, shares_, rng),
                 options.offsets);
    coarseFlood_ = std::make_unique<NodeFlood>(mesh(), coarse_.nodes, charts);
    if (fast_.band.size() == charts) {
      setBase(makeBase(plan_.seeds(), plan_.offsets()));
    } else {
      fast_.band.clear();
      if (threadCount() > 1 && mayTryOthers()) {
        otherStart_ = std::make_unique<OtherStart>(
            [this, charts](Progress& progress) { return runCoarse(charts, progress); });
      }
    }
    restartFlood();
  }

 private:
  /// What the next round is.
  enum class Next { Coarse, OtherStart, Band };

  FloodStart present() const override { return {seedFaces_, plan_.offsets(), {}, {}, fast_}; }
  void startFlood(std::shared_ptr<FloodRecord> record) override {
    seedFaces_.clear();
    for (const Index node : plan_.seeds()) seedFaces_.push_back(coarse_.start[node]);
    if (inBand()) {
      if (!base_) setBase(makeBase(plan_.seeds(), plan_.offsets()));
      bandFlood_->start(base_->band.seeds, fast_.band, options().lookahead, std::move(record));
    } else {
      coarseFlood_->start(plan_.seeds(), plan_.offsets(), options().lookahead, std::move(record));
    }
  }
  std::size_t take(std::size_t count, Progress* progress) override {
    return flood().take(count, progress);
  }
  std::size_t taken() const override {
    return inBand() && !bandFlood_ ? mesh().faceCount() : flood().taken();
  }
  std::vector<Index> labels() const override { return flood().labels(); }
  const char* phaseName() const override {
    return inBand() ? "Flooding around the seams" : "Flooding clusters";
  }

  bool floodAside(const IterationSummary& round, std::shared_ptr<FloodRecord> record,
                  Progress* progress) const override {
    std::shared_ptr<const BandBase> base;
    const std::vector<Index> seeds = nodesOf(round.seeds);
    if (!round.band.empty())
      base = isBase(seeds, round.offsets) ? base_ : makeBase(seeds, round.offsets);
    NodeFlood flood(mesh(), base ? base->band.nodes : coarse_.nodes, seeds.size());
    flood.start(base ? base->band.seeds : seeds, base ? round.band : round.offsets,
                options().lookahead, std::move(record));
    flood.take(kAllFaces, progress);
    return flood.finished();
  }

  IterationSummary measure() override {
    nodeLabel_ = flood().nodeLabels();
    chartGauss_ =
        (inBand() ? base_->band.nodes : coarse_.nodes).chartGauss(nodeLabel_, plan_.seeds().size());
    balance_ = balanceOf(chartGauss_);
    IterationSummary summary;
    summary.stdOverMean = balance_.stdOverMean();
    summary.balanceDefined = balance_.defined;
    return summary;
  }

  void planNext() override {
    if (!inBand()) return plan_.plan(coarseFlood_->flood(), chartGauss_, locked_);
    nextBand_ = fast_.band;
    bandSteps_.update(nextBand_, chartGauss_);
  }

  Judgement judge() override {
    planNext();
    return inBand() ? judgeBand() : judgeCoarse();
  }

  Judgement judgeCoarse() {
    StopReason stop = plan_.judge(badnessOf(balance_));
    Judgement judgement;
    judgement.best = !bandSeen_ && badnessOf(balance_) < best_.badness;
    if (badnessOf(balance_) < best_.badness) {
      best_ = {badnessOf(balance_), plan_.seeds(), plan_.offsets()};
    }
    if (next_ == Next::OtherStart) stop = StopReason::NoImprovement;  // the best of all, once more
    if (stop == StopReason::NotStopped) return judgement;
    const double s = best_.badness * std::sqrt(static_cast<double>(plan_.seeds().size()));
    const bool tryOthers =
        next_ == Next::Coarse && balance_.defined && s > kUnevenCoarse && mayTryOthers();
    next_ = tryOthers ? Next::OtherStart : Next::Band;
    if (!hasSeams()) judgement.stop = stop;
    return judgement;
  }

  Judgement judgeBand() {
    const double badness = badnessOf(balance_);
    Judgement judgement;
    ++bandRounds_;
    judgement.best = !bandSeen_ || badness < bestBand_;
    if (judgement.best) {
      bestBand_ = badness;
      lastGain_ = bandRounds_;
    }
    bandSeen_ = true;
    const double charts = static_cast<double>(plan_.seeds().size());
    if (balance_.defined && bestBand_ * std::sqrt(charts) < kEvenBand) {
      judgement.stop = StopReason::Balanced;
    } else if (bandRounds_ - lastGain_ >= kBandPatience || !options().useOffsets) {
      judgement.stop = StopReason::NoImprovement;
    } else if (bandRounds_ >= bandRoundsOf(options().maxIterations)) {
      judgement.stop = StopReason::MaxIterations;
    }
    return judgement;
  }

  std::optional<std::size_t> takeNext(Progress& progress) override {
    if (inBand()) {
      fast_.band = nextBand_;
      return 0;
    }
    if (next_ == Next::Coarse) return plan_.takeNext();
    if (next_ == Next::OtherStart) {
      progress.beginPhase("Trying other seeds");
      const std::optional<CoarseRound> other = runOtherStart(progress);
      if (!other) return std::nullopt;
      if (other->badness < best_.badness) {
        plan_.standAt(other->seeds, other->offsets);
        return other->seeds.size();
      }
    }
    next_ = Next::Band;
    plan_.standAt(best_.seeds, best_.offsets);
    progress.beginPhase("Freeing faces around the seams");
    setBase(makeBase(best_.seeds, best_.offsets));
    bandRounds_ = lastGain_ = 0;
    bandSteps_.reset();
    fast_.band.assign(best_.seeds.size(), 0);
    return 0;
  }

  void standAt(const IterationSummary& round) override {
    plan_.standAt(nodesOf(round.seeds), round.offsets);
    fast_.band = round.band;
    bandSteps_.reset();
    if (inBand() && !isBase(plan_.seeds(), plan_.offsets())) {
      setBase(makeBase(plan_.seeds(), plan_.offsets()));
    }
  }

  void keepBest() override {
    bestFaces_.clear();
    bestBase_ = inBand() ? base_ : nullptr;
    bestNodeLabel_ = nodeLabel_;
  }
  void rest() override {
    bestFaces_ = bestLabels();
    bestNodeLabel_ = nodeLabel_ = {};
    bestBase_.reset();
    if (!inBand()) return;
    bandFlood_.reset();
    base_.reset();
  }
  std::vector<Index> bestLabels() const override {
    if (!bestFaces_.empty()) return bestFaces_;
    return projectLabels(bestBase_ ? bestBase_->band.nodes : coarse_.nodes, bestNodeLabel_);
  }

  /// Clusters that every seed begins one of; where they do not without, seeds become starts.
  FaceClusters clustersWith(std::span<const Index> seeds, std::size_t charts) {
    const std::size_t size = coarseClusterSize(mesh().faceCount(), charts);
    std::erase_if(fast_.starts, [&](Index face) { return face >= mesh().faceCount(); });
    std::sort(fast_.starts.begin(), fast_.starts.end());
    fast_.starts.erase(std::unique(fast_.starts.begin(), fast_.starts.end()), fast_.starts.end());
    FaceClusters clusters = clusterFaces(mesh(), {}, size, fast_.starts);
    const std::size_t before = fast_.starts.size();
    for (const Index face : seeds) {
      if (clusters.start[clusters.ofFace[face]] != face) fast_.starts.push_back(face);
    }
    if (fast_.starts.size() == before) return clusters;
    std::sort(fast_.starts.begin(), fast_.starts.end());
    return clusterFaces(mesh(), {}, size, fast_.starts);
  }

  bool inBand() const { return !fast_.band.empty(); }
  NodeFlood& flood() const { return inBand() ? *bandFlood_ : *coarseFlood_; }
  NodeGraphSource source() const {
    return {mesh(), *inputs().gaussArea, faceGauss(), *inputs().floodGraph};
  }
  Index nodeOf(Index face) const { return coarse_.nodes.nodeOfFace[face]; }
  std::vector<Index> nodesOf(std::span<const Index> faces) const {
    std::vector<Index> nodes;
    for (const Index face : faces) nodes.push_back(nodeOf(face));
    return nodes;
  }
  RoundPlan planFrom(std::vector<Index> seeds, std::vector<double> offsets) const {
    const std::size_t most = options().maxIterations;
    SegmentOptions coarse = options();
    coarse.patience = coarsePatience(coarse.patience);
    if (coarse.useOffsets && coarse.settle > 0) coarse.detectCycles = false;
    coarse.settle = 0;  // the band evens out better than clusters at rest can
    return {coarse, std::max<std::size_t>(1, most - std::min(most, bandRoundsOf(most))),
            std::move(seeds), std::move(offsets)};
  }
  bool hasSeams() const { return plan_.seeds().size() > mesh().componentCount(); }

  bool mayTryOthers() const { return options().seeds.empty() && options().maxIterations > 1; }

  /// The best round from other seeds; nothing when cancelled before.
  std::optional<CoarseRound> runOtherStart(Progress& progress) {
    std::optional<CoarseRound> other;
    if (otherStart_) {
      other = otherStart_->take(progress);
      if (other) otherStart_.reset();
      return other;
    }
    other = runCoarse(plan_.seeds().size(), progress);
    if (progress.cancelled()) other.reset();
    return other;
  }

  /// The best round of a run from other seeds. Touches nothing that changes after construction.
  CoarseRound runCoarse(std::size_t charts, Progress& progress) const {
    Rng rng(options().rngSeed + kSeedStep);
    RoundPlan plan =
        planFrom(placeCoarseSeeds(coarse_, mesh().componentCount(), charts, {}, shares_, rng), {});
    NodeFlood flood(mesh(), coarse_.nodes, charts);
    CoarseRound best;
    while (!progress.cancelled()) {
      flood.start(plan.seeds(), plan.offsets(), options().lookahead, nullptr);
      flood.take(kAllFaces, &progress);
      if (!flood.finished()) break;
      const std::vector<double> gauss = coarse_.nodes.chartGauss(flood.nodeLabels(), charts);
      const double badness = badnessOf(balanceOf(gauss));
      plan.plan(flood.flood(), gauss, locked_);
      const StopReason stop = plan.judge(badness);
      if (badness < best.badness) best = {badness, plan.seeds(), plan.offsets()};
      if (stop != StopReason::NotStopped) break;
      plan.takeNext();
    }
    return best;
  }

  bool isBase(std::span<const Index> seeds, std::span<const double> offsets) const {
    return base_ &&
           std::equal(seeds.begin(), seeds.end(), base_->seeds.begin(), base_->seeds.end()) &&
           std::equal(offsets.begin(), offsets.end(), base_->offsets.begin(), base_->offsets.end());
  }

  std::shared_ptr<const BandBase> makeBase(const std::vector<Index>& seeds,
                                           const std::vector<double>& offsets) const {
    NodeFlood flood(mesh(), coarse_.nodes, seeds.size());
    flood.start(seeds, offsets, options().lookahead, nullptr);
    flood.take(kAllFaces, nullptr);
    const std::size_t rings = bandRings(mesh().faceCount(), coarse_.nodeCount());
    return std::make_shared<const BandBase>(BandBase{
        seeds, offsets, makeSeamBand(source(), coarse_.nodes, flood.nodeLabels(), seeds, rings)});
  }

  void setBase(std::shared_ptr<const BandBase> base) {
    base_ = std::move(base);
    bandFlood_ = std::make_unique<NodeFlood>(mesh(), base_->band.nodes, base_->seeds.size());
  }

  PartShares shares_;
  CoarseGraph coarse_;
  std::vector<Index> locked_;     ///< nodes
  RoundPlan plan_;                ///< nodes; in the band it rests where the base was flooded from
  std::vector<Index> seedFaces_;  ///< of plan_
  FastFlood fast_;                ///< of the flood at hand
  std::unique_ptr<NodeFlood> coarseFlood_, bandFlood_;
  std::shared_ptr<const BandBase> base_;
  Next next_ = Next::Coarse;
  CoarseRound best_;
  OffsetSteps bandSteps_;
  std::vector<double> nextBand_;
  double bestBand_ = 0;
  std::size_t bandRounds_ = 0, lastGain_ = 0;
  bool bandSeen_ = false;
  std::vector<Index> nodeLabel_, bestNodeLabel_;  ///< of the finished flood, of the best one
  std::shared_ptr<const BandBase> bestBase_;      ///< of the latter; null: nodes are clusters
  std::vector<Index> bestFaces_;                  ///< the same of each face, while at rest
  std::vector<double> chartGauss_;                ///< of the finished flood
  Balance balance_;
  std::unique_ptr<OtherStart> otherStart_;  ///< goes first: reads the others; null: not begun
};

}  // namespace

bool searchesFast(const Mesh& mesh, const SegmentOptions& options) {
  const std::size_t charts = effectiveChartCount(mesh, options.charts, options.seeds.size());
  return options.search == SearchKind::Fast && mesh.faceCount() >= kFastFacesPerChart * charts;
}

std::unique_ptr<Stepper> makeFastFlooding(const SegmentInputs& inputs,
                                          const SegmentOptions& options) {
  return std::make_unique<FastFlooding>(inputs, options);
}

}  // namespace chartflood
