// The search for the number of charts: the shortest seams with which no chart stretches more than
// allowed, over numbers of charts and the relief cuts inside them.

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

#include "core/segment/creases/crease_regions.h"
#include "core/segment/parts/part_shares.h"
#include "core/session/pipeline/pipeline.h"

namespace chartflood {

namespace {

constexpr int kMostRunCharts = 512;
constexpr double kKeptCreases = 0.7;  // of what the parts between creases have on borders
/// The limit is given up where numbers four times as large do not bring the worst chart nearer.
constexpr double kNearer = 0.99;

/// Three numbers between two others, or as many as there are.
std::vector<int> numbersBetween(int low, int high) {
  std::vector<int> counts;
  for (int i = 1; i <= 3; ++i) {
    const int k = low + (high - low) * i / 4;
    if (k > low && k < high && (counts.empty() || counts.back() != k)) counts.push_back(k);
  }
  return counts;
}

/// The largest number that gives no more charts than asking for one: separate parts of a kind are
/// the fewest there are, and crumbs come on top of any number.
int leastCharts(const Mesh& mesh) {
  const std::size_t fewest = countWithParts(mesh, 1).charts;
  std::size_t low = 1, high = mesh.componentCount();
  while (low < high) {
    const std::size_t middle = low + (high - low + 1) / 2;
    if (countWithParts(mesh, middle).charts > fewest) {
      high = middle - 1;
    } else {
      low = middle;
    }
  }
  return static_cast<int>(low);
}

}  // namespace

/// Runs that were tried and the best of them. Batches are the same for any number of threads: what
/// a run is held against is known before its batch begins.
class Pipeline::ChartSearch {
 public:
  ChartSearch(const Pipeline& pipeline, Progress& progress)
      : pipeline_(pipeline), progress_(progress), limit_(pipeline.document_.parameters.maxStretch),
        least_(leastCharts(*pipeline.mesh_)),
        most_(static_cast<int>(std::min<std::size_t>(pipeline.mesh_->faceCount(),
                                                     std::max(kMostRunCharts, least_)))) {}

  /// False when cancelled.
  bool run() { return keepsCreases() ? alongCreases() : upwards(); }

  bool fits() const { return chosen().keeps(limit_); }
  const Run& chosen() const { return set_.runs[set_.chosen]; }
  std::shared_ptr<const RunSet> runs() { return std::make_shared<const RunSet>(std::move(set_)); }
  std::unique_ptr<Pipeline> best() { return std::move(best_); }

 private:
  /// Whether creases are worth more than short seams: where the user says so, and on machine parts
  /// with holes through them. Few charts of these are slit across every hole; those of a body
  /// without holes lie flat with a slit a fifth as long as its creases.
  bool keepsCreases() const {
    if (!pipeline_.wantsCreases()) return false;
    return pipeline_.document_.parameters.start == "creases" || pipeline_.mesh_->genus() > 0;
  }

  /// From the fewest charts on, each number with the relief cuts it needs, as long as seams get
  /// shorter; where cuts alone do not keep the limit, up to the first number that does.
  bool upwards() {
    if (!tryAll({least_})) return false;
    for (int k = least_ + 1; k <= least_ + 3; ++k) {
      const bool before = fits();
      const double seams = chosen().seams;
      if (!tryAll({k})) return false;
      if (before && !(chosen().seams < seams)) break;
    }
    double worst = worstOfChosen();
    for (int k = 6; !fits() && k <= most_; k *= 4) {
      if (!tryAll({k, k * 4 / 3, 2 * k, k * 8 / 3})) return false;
      if (!fits() && worstOfChosen() > kNearer * worst) break;
      worst = worstOfChosen();
    }
    // Between the first number that fits and the one before it.
    while (fits() && set_.chosen > 0 && failed(set_.runs[set_.chosen - 1])) {
      const auto counts =
          numbersBetween(set_.runs[set_.chosen - 1].parameters.charts, chosen().parameters.charts);
      if (counts.empty()) break;
      if (!tryAll(counts)) return false;
    }
    return true;
  }

  /// As few of the parts between creases joined to one as leave most creases on borders.
  bool alongCreases() {
    const auto parts = creaseRegions(*pipeline_.mesh_, *pipeline_.gauss_).count;
    int high = std::clamp(static_cast<int>(parts), least_, most_);
    if (!tryAll({high})) return false;
    creases_ = kKeptCreases * chosen().creases;
    int low = least_ - 1;
    for (auto counts = numbersBetween(low, high); !counts.empty();
         counts = numbersBetween(low, high)) {
      if (!tryAll(counts)) return false;
      for (const Run& run : set_.runs) {
        const int k = run.parameters.charts;
        if (k <= low || k >= high) continue;
        if (run.creases < creases_) {
          low = std::max(low, k);
        } else {
          high = k;
          break;
        }
      }
    }
    return fits() || upwards();
  }

  double worstOfChosen() const {
    return chosen().worst.value_or(std::numeric_limits<double>::infinity());
  }
  bool failed(const Run& run) const { return run.stretch && !run.keeps(limit_); }

  /// Whether a run whose charts are not laid flat yet may become the best one: with relief cuts
  /// that get shorter as the number of charts grows.
  bool worth(const Run& run) const {
    if (run.creases < creases_) return false;
    if (set_.runs.empty() || !fits() || chosen().creases < creases_) return true;
    const double relief = chosen().relief * static_cast<double>(chosen().charts) /
                          static_cast<double>(std::max(run.charts, chosen().charts));
    return run.seams + relief < chosen().seams;
  }

  /// Runs these numbers that were not tried, beside each other.
  bool tryAll(std::vector<int> counts) {
    std::erase_if(counts, [&](int k) {
      return k < least_ || k > most_ ||
             std::any_of(set_.runs.begin(), set_.runs.end(),
                         [&](const Run& run) { return run.parameters.charts == k; });
    });
    progress_.beginPhase("Trying numbers of charts");
    std::vector<Parameters> each(counts.size(), pipeline_.document_.parameters);
    for (std::size_t i = 0; i < counts.size(); ++i) {
      askCharts(each[i], counts[i]);
      double& relief = each[i].reliefStretch;
      if (relief > 0) relief = std::min(relief, limit_);
    }
    auto pipelines = pipeline_.runAll(
        each, [this](const Run& run) { return worth(run); }, progress_);
    if (progress_.cancelled()) return false;
    for (auto& pipeline : pipelines) take(std::move(pipeline));
    return true;
  }

  /// Adds a run; keeps the pipeline if it is the best one now.
  void take(std::unique_ptr<Pipeline> pipeline) {
    set_.runs.push_back(pipeline->asRun(false));
    const int charts = set_.runs.back().parameters.charts;
    std::stable_sort(set_.runs.begin(), set_.runs.end(), [](const Run& a, const Run& b) {
      return a.parameters.charts < b.parameters.charts;
    });
    set_.chosen = shortestWithin(set_.runs, limit_, creases_);
    if (chosen().parameters.charts != charts) return;
    best_ = std::move(pipeline);
  }

  const Pipeline& pipeline_;
  Progress& progress_;
  double limit_;
  int least_, most_;
  double creases_ = 0;  ///< share of the length of sharp edges that is to lie on borders
  RunSet set_;
  std::unique_ptr<Pipeline> best_;
};

bool Pipeline::findChartCount(Progress& progress) {
  ChartSearch search(*this, progress);
  if (!search.run()) return false;
  if (!search.fits()) {
    tell(Notice::Kind::Warning,
         "No number of charts that was tried stretches as little as asked in every chart; " +
             std::to_string(search.chosen().charts) + " stretch least.");
  }
  if (auto best = search.best()) kept_.keep(std::move(best->run_));
  chartRuns_ = search.runs();
  return true;
}

}  // namespace chartflood
