#include "core/segment/seam_cuts.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

#include "core/base/parallel.h"
#include "core/segment/face_clusters.h"
#include "core/segment/pair_cut.h"

namespace chartflood {

namespace {

constexpr std::size_t kSweeps = 5;       // at most, a stage
constexpr std::size_t kLastSweeps = 10;  // those are cheap: few pairs still change
constexpr std::size_t kTogether = 16;    // pairs cut at the same time
constexpr double kLeastArea = 0.1;       // of the mean chart's
constexpr double kLeastGain = 1e-9;
/// From this many faces on time counts more than the last percent.
constexpr std::size_t kManyFaces = 400000;

/// One stage of the annealing.
struct SeamStage {
  double weight;     ///< factor on w
  double band;       ///< factor on the width
  std::size_t size;  ///< faces a cluster
  std::size_t sweeps = kSweeps;
};

/// The annealing schedule. Measured over seven meshes: from a hundredth of the weight on, seams end
/// 10 % shorter than at full weight at once; halving the clusters from stage to stage costs
/// nothing. Over four meshes of 70,000 to 270,000 faces and three floods of each, the energy ends
/// 1.0 % above that of single faces throughout; with clusters twice as large and single faces only
/// in the last, narrow band, in two thirds of the time, 1.9 %.
std::vector<SeamStage> stagesFor(std::size_t faces, std::size_t charts, bool clusters,
                                 bool anneal) {
  const bool many = faces > kManyFaces;
  const double count = static_cast<double>(faces);
  double size = many ? count / 16000 : std::max(std::min(count / 9000, 8.0), count / 32000);
  size = std::min(size, count / (100 * static_cast<double>(charts)));
  if (!clusters) size = 1;
  const auto whole = [](double s) { return static_cast<std::size_t>(std::max(1.0, s)); };
  std::vector<SeamStage> stages;
  if (anneal) {
    stages = {{0.01, 1.5, whole(size)},
              {0.03, 1, whole(size)},
              {0.1, 1, whole(many ? size / 2 : size)},
              {0.3, 0.7, whole(size / 2)}};
  }
  if (many && clusters && anneal) {
    stages.push_back({1, 0.5, whole(size / 4)});
    for (double s = size / 4; s > 8; s /= 4) stages.push_back({1, 0.25, whole(s / 4)});
    stages.push_back({1, 0.125, 1});
  } else {
    stages.push_back({1, 0.5, 1, clusters ? 2 : kSweeps});
    stages.push_back({1, many ? 0.125 : 0.25, 1, clusters ? kLastSweeps : kSweeps});
  }
  return stages;
}

}  // namespace

class SeamCuts::Engine {
 public:
  Engine(const Mesh& mesh, const GaussArea& gauss, std::span<const double> faceGauss,
         std::vector<Index> label, std::size_t charts, std::span<const Index> fixed,
         const Options& options)
      : mesh_(mesh), options_(options), charts_(charts), fixed_(fixed.begin(), fixed.end()),
        tables_(makeSeamTables(mesh, gauss, faceGauss, options.creaseWeight, options.eta,
                               options.sideFactor)),
        label_(std::move(label)),
        stages_(stagesFor(mesh.faceCount(), charts, options.clusters, options.anneal)),
        cuts_(kTogether) {
    record_.start = label_;
    whole_ = gauss.total() + options.eta * mesh.surfaceArea();
    startEnergy_ = energy();
  }

  bool run(Progress& progress) {
    for (; stage_ < stages_.size(); ++stage_) {
      progress.setFraction(static_cast<float>(stage_) / static_cast<float>(stages_.size()));
      if (!runStage(progress)) return false;
      if (stage_ + 1 == stages_.size() && energy() > startEnergy_) fallBack();
    }
    return true;
  }

  std::span<const Index> labels() const { return label_; }
  const SeamRecord& record() const { return record_; }

  double energy() const {
    const auto opposite = mesh_.opposite();
    double length = 0;
    for (Index s = 0; s < opposite.size(); ++s) {
      if (opposite[s] == kNone || opposite[s] < s) continue;
      const bool seam = label_[mesh_.faceOf(s / 3)] != label_[mesh_.faceOf(opposite[s] / 3)];
      if (seam) length += tables_.sideLength[s];
    }
    const SeamLevel level = buildSeamLevel(mesh_, tables_, label_, charts_);  // charts as nodes
    SeamBalance balance = emptyBalance(1);
    for (const double value : level.value) balance.add(value);
    return length * unit() + balance.energy();
  }

 private:
  double unit() const { return mesh_.surfaceArea() > 0 ? 1 / std::sqrt(mesh_.surfaceArea()) : 1; }

  SeamBalance emptyBalance(double factor) const {
    SeamBalance balance;
    balance.weight = options_.weight * factor;
    balance.charts = static_cast<double>(charts_);
    if (options_.oneSided) balance.share = std::max(1e-12, whole_ / balance.charts);
    return balance;
  }

  bool runStage(Progress& progress) {
    if (!inStage_ && !beginStage(progress)) return false;
    inStage_ = true;
    while (sweep_ < stages_[stage_].sweeps) {
      if (!inSweep_) beginSweep();
      inSweep_ = true;
      while (!pairs_.empty()) {
        if (!cutBatch(progress)) return false;
      }
      inSweep_ = false;
      ++sweep_;
      if (!anyChange_) break;
    }
    inStage_ = false;
    return true;
  }

  /// False when it was stopped: the stage must be begun again then.
  bool beginStage(const Progress& progress) {
    if (progress.cancelled()) return false;
    const SeamStage& stage = stages_[stage_];
    state_.band =
        stage.band * options_.band * std::sqrt(mesh_.surfaceArea() / static_cast<double>(charts_));
    FaceClusters clusters = stage.size == 1 && options_.clusters
                                ? clusterNearSeams(mesh_, label_, ringsOf(state_.band))
                                : clusterFaces(mesh_, label_, stage.size);
    if (progress.cancelled()) return false;
    const std::size_t firstFixed = clusters.firstFixed;
    level_ = buildSeamLevel(mesh_, tables_, std::move(clusters.ofFace), clusters.count);
    if (progress.cancelled()) return false;
    const std::size_t nodes = level_.nodeCount();
    for (std::size_t i = firstFixed; i < nodes; ++i) level_.fixed[i] = 1;
    for (const Index face : fixed_) level_.fixed[level_.nodeOfFace[face]] = 1;
    state_.level = &level_;
    state_.label.resize(nodes);
    for (Index f = 0; f < label_.size(); ++f) state_.label[level_.nodeOfFace[f]] = label_[f];
    state_.local.assign(nodes, kNone);
    state_.localArc.resize(level_.arcHead.size());
    state_.distance.resize(nodes);
    state_.seen.assign(nodes, 0);
    state_.unit = unit();
    state_.leastArea = kLeastArea * mesh_.surfaceArea() / static_cast<double>(charts_);
    measureSeamCharts(state_, charts_);
    balance_ = emptyBalance(stage.weight);
    for (const SeamChart& chart : state_.charts) balance_.add(chart.value);
    sweep_ = 0;
    changed_.assign(charts_, 1);
    listFaces();
    return true;
  }

  /// Steps across faces that the last stage's band may need: twice its width.
  std::size_t ringsOf(double band) const {
    double sum = 0;
    std::size_t count = 0;
    const auto opposite = mesh_.opposite();
    for (Index s = 0; s < opposite.size(); ++s) {
      if (opposite[s] == kNone || opposite[s] < s) continue;
      sum += glm::length(tables_.center[mesh_.faceOf(s / 3)] -
                         tables_.center[mesh_.faceOf(opposite[s] / 3)]);
      ++count;
    }
    const double step = count > 0 ? sum / static_cast<double>(count) : 0;
    if (!(step > 0)) return 2;
    const double rings = std::ceil(2 * band / step);
    return static_cast<std::size_t>(std::clamp(rings, 2.0, 1e6));
  }

  /// The faces of each node, for the record.
  void listFaces() {
    faceBegin_.assign(level_.nodeCount() + 2, 0);
    for (const Index node : level_.nodeOfFace) ++faceBegin_[node + 2];
    for (std::size_t i = 2; i < faceBegin_.size(); ++i) faceBegin_[i] += faceBegin_[i - 1];
    faceOfNode_.resize(level_.nodeOfFace.size());
    for (Index f = 0; f < level_.nodeOfFace.size(); ++f) {
      faceOfNode_[faceBegin_[level_.nodeOfFace[f] + 1]++] = f;
    }
  }

  /// The neighbouring pairs of which one chart changed in the last sweep, ascending.
  void beginSweep() {
    pairs_.clear();
    for (Index i = 0; i < level_.nodeCount(); ++i) {
      const Index a = state_.label[i];
      for (Index arc = level_.arcBegin[i]; arc < level_.arcBegin[i + 1]; ++arc) {
        const Index b = state_.label[level_.arcHead[arc]];
        if (a < b && (changed_[a] || changed_[b])) pairs_.emplace_back(a, b);
      }
    }
    std::sort(pairs_.begin(), pairs_.end());
    pairs_.erase(std::unique(pairs_.begin(), pairs_.end()), pairs_.end());
    changed_.assign(charts_, 0);
    anyChange_ = false;
  }

  /// Takes the first pairs without a common chart, cuts them, and applies what lowers the energy.
  /// False when it was stopped: all pairs are as they were then, so that going on gives what going
  /// straight through would have given.
  bool cutBatch(const Progress& progress) {
    if (progress.cancelled()) return false;
    used_.assign(charts_, 0);
    batch_.clear();
    std::size_t kept = 0;
    for (const auto& [a, b] : pairs_) {
      if (batch_.size() < kTogether && !used_[a] && !used_[b]) {
        used_[a] = used_[b] = 1;
        batch_.emplace_back(a, b);
      } else {
        pairs_[kept++] = {a, b};
      }
    }
    pairs_.resize(kept);
    found_.assign(batch_.size(), 0);
    parallelFor(batch_.size(), [&](std::size_t i) {
      found_[i] = cuts_[i].run(state_, balance_, batch_[i].first, batch_[i].second, progress);
    });
    if (progress.cancelled()) {
      pairs_.insert(pairs_.end(), batch_.begin(), batch_.end());
      std::sort(pairs_.begin(), pairs_.end());
      return false;
    }
    for (std::size_t i = 0; i < batch_.size(); ++i) {
      if (found_[i]) apply(cuts_[i], batch_[i].first, batch_[i].second);
    }
    return true;
  }

  void apply(const PairCut& cut, Index a, Index b) {
    SeamChart& chartA = state_.charts[a];
    SeamChart& chartB = state_.charts[b];
    changed_[a] = changed_[b] = 1;
    anyChange_ = true;
    // The other pairs of the batch moved the mean: the gain must hold with it as well.
    SeamBalance after = balance_;
    after.remove(chartA.value);
    after.remove(chartB.value);
    after.add(cut.chartA().value);
    after.add(cut.chartB().value);
    const double change = cut.lengthChange() * state_.unit + after.energy() - balance_.energy();
    if (!(change < -kLeastGain)) return;
    balance_ = after;
    static_cast<SeamSums&>(chartA) = cut.chartA();
    static_cast<SeamSums&>(chartB) = cut.chartB();
    SeamStep step{a, b, record_.faces.size(), 0, 0};
    for (const Index node : cut.toB()) relabel(node, b);
    step.toA = record_.faces.size();
    for (const Index node : cut.toA()) relabel(node, a);
    step.end = record_.faces.size();
    record_.steps.push_back(step);
    shareNodes(chartA.nodes, chartB.nodes, a);
  }

  void relabel(Index node, Index chart) {
    state_.label[node] = chart;
    for (Index k = faceBegin_[node]; k < faceBegin_[node + 1]; ++k) {
      label_[faceOfNode_[k]] = chart;
      record_.faces.push_back(faceOfNode_[k]);
    }
  }

  /// Sorts the nodes of two charts into theirs by their labels.
  void shareNodes(std::vector<Index>& nodesA, std::vector<Index>& nodesB, Index a) {
    merged_.resize(nodesA.size() + nodesB.size());
    std::merge(nodesA.begin(), nodesA.end(), nodesB.begin(), nodesB.end(), merged_.begin());
    nodesA.clear();
    nodesB.clear();
    for (const Index node : merged_) (state_.label[node] == a ? nodesA : nodesB).push_back(node);
  }

  /// Annealing made it worse, as happens on meshes of few faces with their Gauss area in few
  /// corners: begins again with the last stages at full weight, and when that is no better either,
  /// with what was there.
  void fallBack() {
    label_ = record_.start;
    record_.steps.clear();
    record_.faces.clear();
    if (std::exchange(fellBack_, true)) return;
    stages_ = stagesFor(mesh_.faceCount(), charts_, false, false);
    stage_ = static_cast<std::size_t>(-1);  // the loop goes on with the first
  }

  const Mesh& mesh_;
  const Options options_;
  const std::size_t charts_;
  const std::vector<Index> fixed_;
  const SeamTables tables_;
  std::vector<Index> label_;  ///< of each face
  SeamRecord record_;
  double whole_ = 0;  ///< B of the whole surface
  double startEnergy_ = 0;
  bool fellBack_ = false;

  std::vector<SeamStage> stages_;
  std::size_t stage_ = 0, sweep_ = 0;
  bool inStage_ = false, inSweep_ = false, anyChange_ = false;
  SeamLevel level_;
  SeamState state_;
  SeamBalance balance_;
  std::vector<Index> faceBegin_, faceOfNode_;
  std::vector<std::uint8_t> changed_, used_, found_;
  std::vector<std::pair<Index, Index>> pairs_, batch_;
  std::vector<PairCut> cuts_;
  std::vector<Index> merged_;
};

SeamCuts::SeamCuts(const Mesh& mesh, const GaussArea& gauss, std::span<const double> faceGauss,
                   std::vector<Index> label, std::size_t charts, std::span<const Index> fixed,
                   const Options& options)
    : engine_(std::make_unique<Engine>(mesh, gauss, faceGauss, std::move(label), charts, fixed,
                                       options)) {}
SeamCuts::~SeamCuts() = default;

bool SeamCuts::run(Progress& progress) { return engine_->run(progress); }
std::span<const Index> SeamCuts::labels() const { return engine_->labels(); }
double SeamCuts::energy() const { return engine_->energy(); }
const SeamRecord& SeamCuts::record() const { return engine_->record(); }

}  // namespace chartflood
