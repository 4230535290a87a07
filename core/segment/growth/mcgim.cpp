#include "core/segment/growth/mcgim.h"

#include <algorithm>
#include <set>
#include <utility>

#include <glm/geometric.hpp>

#include "core/flood/chart_center.h"
#include "core/segment/growth/disk_guard.h"
#include "core/segment/growth/growth_rounds.h"
#include "core/segment/growth/mcgim_price.h"
#include "core/segment/parts/seeds.h"

namespace chartflood {

namespace {

/// Length of the path so far and the step, dearer where the face turns away from the chart.
struct PathCost {
  float lambda = 1;

  float operator()(float here, const glm::vec3& normal, const GrowthFace& face,
                   float length) const {
    return here + mcgimStep(lambda, normal, face.normal, length);
  }
};

/// A finished growth as ChartCenter looks at it.
class GrownCharts {
 public:
  GrownCharts(const GrowthGraph& graph, const std::vector<glm::vec3>& normals, PathCost cost)
      : graph_(graph), normals_(normals), cost_(cost) {}

  std::size_t faceCount() const { return graph_.faces.size(); }
  Index label(Index face) const { return graph_.faces[face].label; }
  bool onBorder(Index face) const {
    for (Index a = graph_.begin(face); a < graph_.begin(face + 1); ++a) {
      const Index next = graph_.arcs[a].face;
      if (next == kNone || label(next) != label(face)) return true;
    }
    return false;
  }
  template <class Visit>
  void forEachWay(Index face, const Visit& visit) const {
    const Index chart = label(face);
    for (Index a = graph_.begin(face); a < graph_.begin(face + 1); ++a) {
      const GrowthArc& arc = graph_.arcs[a];
      if (arc.face == kNone) continue;
      visit(arc.face, cost_(0, normals_[chart], graph_.faces[arc.face], arc.length));
    }
  }
  void prefetchWays(Index face) const { __builtin_prefetch(&graph_.faces[face]); }

 private:
  const GrowthGraph& graph_;
  const std::vector<glm::vec3>& normals_;
  PathCost cost_;
};

class Mcgim final : public GrowthMethod {
 public:
  Mcgim(std::shared_ptr<const Mesh> mesh, const SegmentOptions& options, std::size_t chartCount)
      : mesh_(std::move(mesh)), options_(options), chartCount_(chartCount), guard_(*mesh_),
        lambda_(static_cast<float>(options.mcgim.lambda)),
        flood_(
            buildGrowthGraph(*mesh_), PathCost{lambda_},
            {options.mcgim.runningNormals, options.mcgim.disks ? &guard_ : nullptr, options.even}),
        charts_(flood_.graph(), normals_, PathCost{lambda_ + 1}), center_(charts_) {}

  void start(const GrowthStart& start, std::shared_ptr<FloodRecord> record) override {
    flood_.start(start, std::move(record));
  }
  std::size_t advance(std::size_t count, Progress* progress) override {
    return flood_.advance(count, progress);
  }
  bool floodAside(const GrowthStart& start, std::shared_ptr<FloodRecord> record,
                  Progress* progress) const override {
    return flood_.aside(start, std::move(record), progress);
  }
  bool finished() const override { return flood_.finished(); }
  std::size_t taken() const override { return flood_.taken(); }
  const std::vector<GrowthFace>& faces() const override { return flood_.graph().faces; }

  std::shared_ptr<ChartPrice> price(const GrowthStart& start) const override {
    return makeMcgimPrice(flood_.graph(), start, lambda_);
  }

  double measure(const GrowthStart& present) override {
    present_ = present;
    double cost = 0;
    costs_.assign(present.seeds.size(), 0);
    std::vector<glm::dvec3> sum(present.seeds.size(), glm::dvec3(0));
    for (const GrowthFace& face : faces()) {
      cost += static_cast<double>(face.best);
      costs_[face.label] += static_cast<double>(face.best);
      sum[face.label] += static_cast<double>(face.area) * glm::dvec3(face.normal);
    }
    next_ = present;
    normals_.resize(sum.size());
    for (std::size_t c = 0; c < sum.size(); ++c) {
      const double length = glm::length(sum[c]);
      if (length > 0) next_.normals[c] = sum[c] / length;
      normals_[c] = glm::vec3(next_.normals[c]);
    }
    const std::vector<Index> centers =
        center_.find(present.seeds, flood_.graph().meanLength * static_cast<double>(lambda_ + 1));
    for (std::size_t c = 0; c < centers.size(); ++c) {
      if (!options_.isLocked(present.seeds[c])) next_.seeds[c] = centers[c];
    }
    return cost;
  }

  std::vector<double> chartCosts() const override { return costs_; }
  GrowthStart relaxed() override { return next_; }

  Verdict judge() override {
    const bool rests = next_.seeds == present_.seeds;
    seen_.insert(present_.seeds);
    const bool cycle = options_.detectCycles && !rests && seen_.contains(next_.seeds);
    if (present_.seeds.size() < chartCount_) {
      if (!rests && !cycle && ++roundsHere_ < kRoundsOnTheWay) return {{}, next_};
      roundsHere_ = 0;
      seen_.clear();
      return {{}, moreCharts()};
    }
    if (rests) return {StopReason::Converged, {}};
    if (cycle) return {StopReason::Cycle, {}};
    return {{}, next_};
  }

 private:
  /// With fewer charts than wanted, seeds need not rest quite: each new one unsettles them again.
  static constexpr std::size_t kRoundsOnTheWay = 4;

  /// New seeds where growth came last, at most one a chart.
  GrowthStart moreCharts() const {
    GrowthStart next = next_;
    std::vector<Index> last(next.seeds.size(), kNone);
    for (Index f = 0; f < faces().size(); ++f) {
      const Index chart = faces()[f].label;
      if (f == next.seeds[chart]) continue;
      if (last[chart] == kNone || faces()[f].best > faces()[last[chart]].best) last[chart] = f;
    }
    std::erase(last, kNone);
    std::stable_sort(last.begin(), last.end(), [&](Index a, Index b) {
      return faces()[a].best != faces()[b].best ? faces()[a].best > faces()[b].best : a < b;
    });
    const std::size_t count = std::min(last.size(), seedsToAdd(next.seeds.size(), chartCount_));
    for (std::size_t i = 0; i < count; ++i) {
      next.seeds.push_back(last[i]);
      next.normals.emplace_back(faces()[last[i]].normal);
    }
    return next;
  }

  std::shared_ptr<const Mesh> mesh_;
  SegmentOptions options_;
  std::size_t chartCount_;
  DiskGuard guard_;
  float lambda_;
  GrowthFlood<PathCost> flood_;
  std::vector<glm::vec3> normals_;  ///< of the finished charts
  std::vector<double> costs_;       ///< likewise: of the paths to their faces
  GrownCharts charts_;
  ChartCenter<GrownCharts> center_;
  GrowthStart present_, next_;
  std::set<std::vector<Index>> seen_;  ///< seeds of the rounds with this number of charts
  std::size_t roundsHere_ = 0;
};

}  // namespace

std::unique_ptr<Stepper> makeMcgim(const SegmentInputs& inputs, const SegmentOptions& options) {
  const GrowthStart first = firstGrowthStart(inputs, options);
  const std::size_t charts = effectiveChartCount(
      *inputs.mesh, options.charts, std::max(options.seeds.size(), first.seeds.size()));
  return makeGrowthRounds("mcgim", inputs, options,
                          std::make_unique<Mcgim>(inputs.mesh, options, charts), first, charts);
}

}  // namespace chartflood
