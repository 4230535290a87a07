#include "core/segment/borders/seam_cuts.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

#include "core/segment/borders/bordered_charts.h"
#include "core/segment/borders/seam_schedule.h"
#include "core/segment/borders/seam_sweep.h"
#include "core/segment/parts/face_clusters.h"

namespace chartflood {

namespace {

/// Of the mean chart's area, below which no chart is made smaller. A fold may hold a chart's share
/// of Gauss area in very little surface; where balance is one-sided nothing asks for such small
/// charts.
constexpr double kLeastArea = 0.04, kLeastAreaOneSided = 0.1;
/// What a chart gains by getting nearer to a disk, in widths of a chart: cutting it open costs
/// about one.
constexpr double kDefect = 1;
/// Width of the band in each pass of a stage against the one before. Over four meshes the energy
/// ends 0.7 % lower than with bands as wide throughout, in two thirds of the time. Where balance is
/// one-sided they stay as wide, as seams lose creases else.
constexpr double kNarrower = 0.7;
/// Of energy that a cut must gain, some 6e-5 of all: half of all cuts need not go on then, and the
/// ends scatter by more.
constexpr double kLeastGain = 5e-4;

}  // namespace

class SeamCuts::Engine {
 public:
  Engine(const Mesh& mesh, const GaussArea& gauss, std::span<const double> faceGauss,
         std::vector<Index> label, std::size_t charts, std::span<const Index> fixed,
         const Options& options)
      : mesh_(mesh), options_(options), charts_(charts), fixed_(fixed.begin(), fixed.end()),
        tables_(makeSeamTables(mesh, gauss, faceGauss, options.creaseWeight, options.eta,
                               options.sideFactor)),
        label_(std::move(label)), bordered_(borderedCharts(mesh, label_, charts)),
        evened_(static_cast<std::size_t>(std::count(bordered_.begin(), bordered_.end(), 1))),
        stages_(stagesFor(options)) {
    record_.start = label_;
    if (options_.price != nullptr) options_.price->fit(label_);
    whole_ = gauss.total() + options.eta * mesh.surfaceArea();
    surface_ = mesh.surfaceArea();
    if (evened_ < charts_) leaveLoneCharts();
    if (!options_.sketch) startEnergy_ = energy();
  }

  bool run(Progress& progress) {
    for (; stage_ < stages_.size(); ++stage_) {
      progress.setFraction(static_cast<float>(stage_) / static_cast<float>(stages_.size()));
      if (!runStage(progress)) return false;
      const bool last = stage_ + 1 == stages_.size();
      if (last && !options_.sketch && energy() > startEnergy_) fallBack();
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
    SeamBalance balance = emptyBalance(options_.weight);
    for (std::size_t c = 0; c < charts_; ++c) {
      if (bordered_[c] != 0) balance.add(level.value[c]);
    }
    const double own = options_.price != nullptr ? options_.price->total(label_) : 0;
    return length * unit() + balance.energy() + own;
  }

 private:
  double unit() const { return surface_ > 0 ? 1 / std::sqrt(surface_) : 1; }

  /// Charts that are all of their part count neither as charts nor as surface.
  void leaveLoneCharts() {
    const SeamLevel level = buildSeamLevel(mesh_, tables_, label_, charts_);  // charts as nodes
    for (std::size_t c = 0; c < charts_; ++c) {
      if (bordered_[c] != 0) continue;
      whole_ -= level.value[c];
      surface_ -= level.area[c];
    }
  }

  /// One-sided balance holds no charts that are to be more even or less: it has no common way.
  std::vector<SeamStage> stagesFor(const Options& options) const {
    const std::size_t faces = mesh_.faceCount();
    if (options.sketch) {
      std::vector<SeamStage> stages = seamSketch(faces, evened_, options.anneal);
      for (SeamStage& stage : stages) stage.weight *= options.weight;
      return stages;
    }
    if (options.anneal && !options.oneSided) {
      return seamScheduleTo(options.weight, faces, evened_, options.clusters);
    }
    std::vector<SeamStage> stages = seamSchedule(faces, evened_, options.clusters, options.anneal);
    for (SeamStage& stage : stages) stage.weight *= options.weight;
    return stages;
  }

  SeamBalance emptyBalance(double weight) const {
    SeamBalance balance;
    balance.weight = weight;
    balance.charts = static_cast<double>(evened_);
    if (options_.oneSided) balance.share = std::max(1e-12, whole_ / balance.charts);
    return balance;
  }

  bool runStage(Progress& progress) {
    if (!inStage_ && !beginStage(progress)) return false;
    inStage_ = true;
    while (sweep_ < stages_[stage_].sweeps) {
      if (!inSweep_) pass_.begin(state_, balance_, changed_);
      inSweep_ = true;
      if (!pass_.run(state_, progress)) return false;
      inSweep_ = false;
      ++sweep_;
      if (!options_.oneSided) state_.band *= kNarrower;
      if (!takeSteps()) break;
    }
    inStage_ = false;
    return true;
  }

  /// False when it was stopped: the stage must be begun again then.
  bool beginStage(const Progress& progress) {
    if (progress.cancelled()) return false;
    const SeamStage& stage = stages_[stage_];
    const double charts = static_cast<double>(evened_);
    state_.band = stage.band * options_.band * std::sqrt(surface_ / charts);
    // A sketch goes on with the clusters of its last stage, which are still within charts.
    const bool sameNodes =
        options_.sketch && stage_ > 0 && stage.size > 1 && stages_[stage_ - 1].size == stage.size;
    if (!sameNodes && !makeNodes(stage, progress)) return false;
    state_.unit = unit();
    state_.leastGain = kLeastGain;
    state_.price = options_.price;
    if (options_.price != nullptr) options_.price->fit(label_);
    state_.defect = kDefect / std::sqrt(charts);
    state_.leastArea = (options_.oneSided ? kLeastAreaOneSided : kLeastArea) * surface_ / charts;
    measureSeamCharts(state_, charts_);
    measureBalance();
    sweep_ = 0;
    changed_.assign(charts_, 1);
    return true;
  }

  /// The level of a stage; false when it was stopped.
  bool makeNodes(const SeamStage& stage, const Progress& progress) {
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

  /// Takes over what a pass moved; false when that was nothing.
  bool takeSteps() {
    changed_.assign(charts_, 0);
    bool any = false;
    for (const SeamSweep::Step& moved : pass_.steps()) {
      if (moved.toA.empty() && moved.toB.empty()) continue;
      changed_[moved.a] = changed_[moved.b] = 1;
      any = true;
      SeamStep step{moved.a, moved.b, record_.faces.size(), 0, 0};
      for (const Index node : moved.toB) relabel(node, moved.b);
      step.toA = record_.faces.size();
      for (const Index node : moved.toA) relabel(node, moved.a);
      step.end = record_.faces.size();
      record_.steps.push_back(step);
    }
    measureBalance();
    if (any && options_.price != nullptr) options_.price->fit(label_);
    return any;
  }

  void measureBalance() {
    balance_ = emptyBalance(stages_[stage_].weight);
    for (std::size_t c = 0; c < charts_; ++c) {
      if (bordered_[c] != 0) balance_.add(state_.charts[c].value);
    }
  }

  void relabel(Index node, Index chart) {
    for (Index k = level_.faceBegin[node]; k < level_.faceBegin[node + 1]; ++k) {
      label_[level_.faceOfNode[k]] = chart;
      record_.faces.push_back(level_.faceOfNode[k]);
    }
  }

  /// Annealing made it worse, as happens on meshes of few faces with their Gauss area in few
  /// corners: begins again with the last stages at full weight, and when that is no better either,
  /// with what was there.
  void fallBack() {
    label_ = record_.start;
    record_.steps.clear();
    record_.faces.clear();
    if (std::exchange(fellBack_, true)) return;
    Options last = options_;
    last.clusters = last.anneal = false;
    stages_ = stagesFor(last);
    stage_ = static_cast<std::size_t>(-1);  // the loop goes on with the first
  }

  const Mesh& mesh_;
  const Options options_;
  const std::size_t charts_;
  const std::vector<Index> fixed_;
  const SeamTables tables_;
  std::vector<Index> label_;                  ///< of each face
  const std::vector<std::uint8_t> bordered_;  ///< as borderedCharts() has it
  const std::size_t evened_;                  ///< how many those are
  SeamRecord record_;
  double whole_ = 0;    ///< B of the surface of bordered charts
  double surface_ = 0;  ///< its area
  double startEnergy_ = 0;
  bool fellBack_ = false;

  std::vector<SeamStage> stages_;
  std::size_t stage_ = 0, sweep_ = 0;
  bool inStage_ = false, inSweep_ = false;
  SeamLevel level_;
  SeamState state_;
  SeamBalance balance_;
  SeamSweep pass_;
  std::vector<std::uint8_t> changed_;  ///< charts that the last pass changed
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
