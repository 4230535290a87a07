#include "core/segment/growth/vsa.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>

#include <glm/geometric.hpp>

#include "core/base/rng.h"
#include "core/segment/growth/growth_rounds.h"
#include "core/segment/growth/vsa_price.h"
#include "core/segment/growth/vsa_regions.h"
#include "core/segment/parts/seeds.h"

namespace chartflood {

namespace {

/// L2,1: area * |n - N|^2, whatever way the face was reached.
struct FlatnessCost {
  float operator()(float, const glm::vec3& normal, const GrowthFace& face, float) const {
    const glm::vec3 d = face.normal - normal;
    return face.area * glm::dot(d, d);
  }
};

class Vsa final : public GrowthMethod {
 public:
  Vsa(GrowthGraph graph, const SegmentOptions& options, std::size_t chartCount)
      : options_(options), chartCount_(chartCount),
        flood_(std::move(graph), {}, {.even = options.even}) {}

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
    return makeVsaPrice(faces(), start.normals);
  }

  double measure(const GrowthStart& present) override {
    present_ = present;
    regions_ = fitRegions(faces(), present.normals);
    cost_ = 0;
    for (const VsaRegion& region : regions_) cost_ += region.cost;
    return cost_;
  }

  std::vector<double> chartCosts() const override {
    std::vector<double> costs;
    for (const VsaRegion& region : regions_) costs.push_back(region.cost);
    return costs;
  }

  GrowthStart relaxed() override {
    GrowthStart next;
    for (std::size_t c = 0; c < regions_.size(); ++c) {
      const Index seed = present_.seeds[c];
      const bool stays = options_.isLocked(seed) || regions_[c].best == kNone;
      next.seeds.push_back(stays ? seed : regions_[c].best);
      next.normals.push_back(regions_[c].normal);
    }
    return next;
  }

  Verdict judge() override {
    if (regions_.size() < chartCount_) return {StopReason::NotStopped, moreCharts()};
    GrowthStart next = relaxed();
    const bool rests = next == present_;
    const bool gains = !least_ || cost_ < *least_ * (1 - kGain);
    if (gains) {
      least_ = cost_;
      stalled_ = 0;
    } else {
      ++stalled_;
    }
    if (!rests && stalled_ < kPatience) return {StopReason::NotStopped, std::move(next)};
    if (options_.vsa.teleport) {
      if (std::optional<GrowthStart> teleported = teleport(std::move(next))) {
        stalled_ = 0;
        return {StopReason::NotStopped, std::move(*teleported)};
      }
    }
    return {rests ? StopReason::Converged : StopReason::NoImprovement, {}};
  }

 private:
  static constexpr double kGain = 1e-4;           ///< less is no gain
  static constexpr std::size_t kPatience = 3;     ///< rounds without gain that end relaxing
  static constexpr std::size_t kRelaxations = 5;  ///< floods for each doubling
  static constexpr std::size_t kTeleports = 10;   ///< in all
  static constexpr std::size_t kFailures = 4;     ///< in a row

  /// What a teleportation began from, to go back to and try the next pair.
  struct Base {
    GrowthStart start;
    double cost = 0;
    std::vector<VsaRegion> regions;
    Index dearest = kNone;                       ///< face that the freed seed goes to
    std::vector<Index> mergedSeed;               ///< of each entry of `pairs`
    std::vector<std::pair<Index, Index>> pairs;  ///< cheapest first
  };

  /// Seeds on the worst faces of the worst regions, one each: one at a time, or doubling with some
  /// rounds of rest between.
  GrowthStart moreCharts() {
    GrowthStart next = relaxed();
    std::size_t wanted = seedsToAdd(regions_.size(), chartCount_);
    if (options_.vsa.seeding == VsaSeeding::Doubling) {
      if (++relaxations_ < kRelaxations) return next;
      relaxations_ = 0;
      wanted = std::min(chartCount_ - regions_.size(), regions_.size());
    }
    std::vector<Index> order(regions_.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) {
      const VsaRegion &x = regions_[a], &y = regions_[b];
      return x.cost != y.cost ? x.cost > y.cost : x.area > y.area;
    });
    for (const Index c : order) {
      if (wanted == 0) break;
      const Index face = worstBut(regions_[c], next.seeds[c]);
      if (face == kNone) continue;
      addSeed(next, face);
      --wanted;
    }
    return next;
  }

  static Index worstBut(const VsaRegion& region, Index seed) {
    return region.worst == seed ? region.secondWorst : region.worst;
  }
  void addSeed(GrowthStart& start, Index face) const {
    start.seeds.push_back(face);
    start.normals.emplace_back(faces()[face].normal);
  }

  /// Where to start from after the next teleportation; none when no pair is worth it or enough were
  /// tried. `relaxed` is what the round at hand would go on with.
  std::optional<GrowthStart> teleport(GrowthStart relaxed) {
    if (teleports_ == kTeleports || regions_.size() < 3) return std::nullopt;
    if (!base_ || *least_ < base_->cost * (1 - kGain)) {
      newBase(std::move(relaxed));
      failures_ = 0;
    } else if (++failures_ == kFailures) {
      return std::nullopt;
    } else if (++tried_ >= base_->pairs.size()) {
      // Charts of the same cost elsewhere may have a better place to leave from.
      if (cost_ > *least_ * (1 + kGain)) return std::nullopt;
      newBase(std::move(relaxed));
    }
    if (base_->pairs.empty()) return std::nullopt;
    ++teleports_;
    return teleported(tried_);
  }

  void newBase(GrowthStart start) {
    base_ = {std::move(start), *least_, regions_, kNone, {}, {}};
    tried_ = 0;
    const Index worst = worstRegion();
    base_->dearest = worstBut(regions_[worst], base_->start.seeds[worst]);
    // A chart of one face costs something too, by rounding, but has no face to give away.
    if (base_->dearest == kNone) return;
    const auto byCost = [&](const auto& a, const auto& b) {
      const double x = mergeCost(regions_[a.first], regions_[a.second]);
      const double y = mergeCost(regions_[b.first], regions_[b.second]);
      return x != y ? x < y : a < b;
    };
    base_->pairs = neighbourCharts(flood_.graph());
    std::erase_if(base_->pairs, [&](const auto& pair) {
      const bool both = options_.isLocked(base_->start.seeds[pair.first]) &&
                        options_.isLocked(base_->start.seeds[pair.second]);
      return both || pair.first == worst || pair.second == worst ||
             !(mergeCost(regions_[pair.first], regions_[pair.second]) < 0.5 * regions_[worst].cost);
    });
    std::sort(base_->pairs.begin(), base_->pairs.end(), byCost);
    if (base_->pairs.size() > kFailures) base_->pairs.resize(kFailures);
    for (const auto& [a, b] : base_->pairs) {
      base_->mergedSeed.push_back(bestOfTwo(faces(), a, b, mergedNormal(a, b)));
    }
  }

  Index worstRegion() const {
    const auto worst =
        std::max_element(regions_.begin(), regions_.end(),
                         [](const VsaRegion& a, const VsaRegion& b) { return a.cost < b.cost; });
    return static_cast<Index>(worst - regions_.begin());
  }

  glm::dvec3 mergedNormal(Index a, Index b) const {
    const glm::dvec3 sum = base_->regions[a].sum + base_->regions[b].sum;
    const double length = glm::length(sum);
    return length > 0 ? sum / length : base_->regions[a].normal;
  }

  /// The base's start with its pair number `i` made one and the freed seed on the worst face.
  GrowthStart teleported(std::size_t i) const {
    GrowthStart next = base_->start;
    auto [keeps, moves] = base_->pairs[i];
    if (options_.isLocked(next.seeds[moves])) std::swap(keeps, moves);
    if (!options_.isLocked(next.seeds[keeps]) && base_->mergedSeed[i] != kNone) {
      next.seeds[keeps] = base_->mergedSeed[i];
    }
    next.normals[keeps] = mergedNormal(keeps, moves);
    next.seeds[moves] = base_->dearest;
    next.normals[moves] = glm::dvec3(faces()[base_->dearest].normal);
    return next;
  }

  SegmentOptions options_;
  std::size_t chartCount_;
  GrowthFlood<FlatnessCost> flood_;
  GrowthStart present_;
  std::vector<VsaRegion> regions_;
  double cost_ = 0;
  std::optional<double> least_;  ///< of the rounds with all charts
  std::size_t stalled_ = 0, relaxations_ = 0, teleports_ = 0, failures_ = 0;
  std::size_t tried_ = 0;  ///< pairs of the base
  std::optional<Base> base_;
};

/// Random faces until there are enough seeds: the cheap start.
void addRandomSeeds(const GrowthGraph& graph, std::size_t wanted, std::uint32_t rngSeed,
                    GrowthStart& start) {
  Rng rng(rngSeed + 1);
  std::vector<bool> taken(graph.faces.size(), false);
  for (const Index seed : start.seeds) taken[seed] = true;
  std::vector<Index> free;
  for (Index f = 0; f < graph.faces.size(); ++f) {
    if (!taken[f]) free.push_back(f);
  }
  while (start.seeds.size() < wanted) {
    const std::uint32_t pick = rng.below(static_cast<std::uint32_t>(free.size()));
    start.seeds.push_back(free[pick]);
    start.normals.emplace_back(graph.faces[free[pick]].normal);
    free[pick] = free.back();
    free.pop_back();
  }
}

}  // namespace

std::unique_ptr<Stepper> makeVsa(const SegmentInputs& inputs, const SegmentOptions& options) {
  GrowthStart first = firstGrowthStart(inputs, options);
  const std::size_t charts = effectiveChartCount(
      *inputs.mesh, options.charts, std::max(options.seeds.size(), first.seeds.size()));
  GrowthGraph graph = buildGrowthGraph(*inputs.mesh);
  // Seeds that come with proxies are a round of before: it must come out the same.
  const bool goesOn = !options.normals.empty();
  if (options.vsa.seeding == VsaSeeding::Random && !goesOn) {
    addRandomSeeds(graph, charts, options.rngSeed, first);
  }
  return makeGrowthRounds("vsa", inputs, options,
                          std::make_unique<Vsa>(std::move(graph), options, charts), first, charts);
}

double vsaCost(const Mesh& mesh, std::span<const Index> label, std::size_t chartCount) {
  GrowthGraph graph = buildGrowthGraph(mesh);
  for (std::size_t f = 0; f < label.size(); ++f) graph.faces[f].label = label[f];
  double cost = 0;
  const std::vector<glm::dvec3> none(chartCount, glm::dvec3(0));
  for (const VsaRegion& region : fitRegions(graph.faces, none)) cost += region.cost;
  return cost;
}

}  // namespace chartflood
