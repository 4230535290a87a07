#include "core/pack/pack_search.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numbers>

#include "core/base/parallel.h"
#include "core/base/rng.h"
#include "core/pack/free_space.h"

namespace chartflood {

namespace {

/// Share of the square that the charts should cover when they are placed one by one: more than
/// they can, so that squeezing starts from charts that overlap a little.
constexpr double kFirstFill = 0.78;
/// Turns tried for every chart that is placed; fewer where there are many charts.
constexpr int kTurns = 20;
constexpr int kStartSteps = 60, kRoundSteps = 40;
constexpr std::uint32_t kSeed = 1;
/// Depths, in 1024ths of the square's side, that the walls press charts into each other, softest
/// last.
constexpr double kStartDepths[] = {4, 0.5, 0.0625};
constexpr double kRoundDepths[] = {2, 0.25, 0.03125};

/// How much is tried; points of outlines times steps of squeezing are what it costs.
struct Plan {
  std::size_t starts;
  struct Stage {
    std::size_t chains;
    int rounds;
  };
  std::vector<Stage> stages;
};

Plan planFor(std::span<const PackShape> shapes, double effort) {
  double points = 0;
  for (const PackShape& shape : shapes) points += static_cast<double>(shape.points.size());
  // A square of twenty usual charts has about 2500 points.
  const double less = std::clamp(effort, 0.0, 1.0) * std::min(1.0, 2500 / points);
  const auto rounds = [&](double most) { return 2 + static_cast<int>(most * less); };
  const std::size_t starts = shapes.size() > 250 ? 2 : shapes.size() > 60 ? 4 : 8;
  return {effort < 0.5 ? 2 : starts, {{4, rounds(60)}, {2, rounds(160)}}};
}

double unit(Rng& rng) { return (rng.below(1u << 24) + 0.5) / (1u << 24); }

/// A layout on its way to a denser one.
struct Chain {
  PackLayout layout;
  double side = 0;            ///< of the layout, what is still pressed in made good
  std::vector<double> sides;  ///< after each depth of squeezing
};

bool denser(const Chain& a, const Chain& b) { return a.side < b.side; }

class Search {
 public:
  Search(std::span<const PackShape> shapes, const PackGaps& gaps, const Progress& progress)
      : shapes_(shapes), gaps_(gaps), progress_(progress),
        turns_(std::clamp(static_cast<int>(60 * kTurns / shapes.size()), 4, kTurns)) {}

  Chain start(Rng& rng) const {
    std::vector<Index> all(shapes_.size());
    for (Index i = 0; i < all.size(); ++i) all[i] = i;
    Chain chain;
    const double side = std::sqrt(1 / kFirstFill);
    chain.layout = {side, std::vector<Pose>(shapes_.size())};
    FreeSpace space(side, gaps_.between * side, gaps_.border * side);
    place(chain.layout, space, largeFirst(all, 0.3, rng), rng);
    squeeze(chain, kStartDepths, kStartSteps, nullptr);
    return chain;
  }

  /// Takes some shapes out and puts them back in; keeps the result when it is denser.
  void improve(Chain& chain, Rng& rng) const {
    Chain next{chain.layout, 0, {}};
    const std::vector<Index> taken = someShapes(chain.layout, rng);
    std::vector<bool> out(shapes_.size(), false);
    for (const Index i : taken) out[i] = true;
    // Tighter than it was, so that only better places fit.
    constexpr double kTighter = 0.99;
    next.layout.side *= kTighter;
    for (Pose& pose : next.layout.poses) pose.x *= kTighter, pose.y *= kTighter;
    const double side = next.layout.side;
    FreeSpace space(side, gaps_.between * side, gaps_.border * side);
    for (Index i = 0; i < shapes_.size(); ++i) {
      if (!out[i]) space.add(shapes_[i], next.layout.poses[i]);
    }
    place(next.layout, space, largeFirst(taken, 0.5, rng), rng);
    if (squeeze(next, kRoundDepths, kRoundSteps, &chain) && denser(next, chain))
      chain = std::move(next);
  }

 private:
  /// Large shapes first, in an order that differs from time to time.
  std::vector<Index> largeFirst(const std::vector<Index>& some, double disorder, Rng& rng) const {
    std::vector<std::pair<double, Index>> keys;
    for (const Index i : some) {
      const double size = std::log(static_cast<double>(shapes_[i].area) + 1e-12);
      keys.emplace_back(disorder * (2 * unit(rng) - 1) - size, i);
    }
    std::sort(keys.begin(), keys.end());
    std::vector<Index> order;
    for (const auto& [key, i] : keys) order.push_back(i);
    return order;
  }

  void place(PackLayout& layout, FreeSpace& space, const std::vector<Index>& order,
             Rng& rng) const {
    for (const Index i : order) {
      if (progress_.cancelled()) return;
      layout.poses[i] = space.bestPose(shapes_[i], 2 * std::numbers::pi * unit(rng), turns_);
      space.add(shapes_[i], layout.poses[i]);
    }
  }

  /// A few neighbours, or a few from anywhere.
  std::vector<Index> someShapes(const PackLayout& layout, Rng& rng) const {
    const Index count = static_cast<Index>(shapes_.size());
    const std::size_t wanted = std::min<Index>(count, 2 + rng.below(4));
    const Index first = rng.below(count);
    const bool neighbours = rng.below(2) == 0;
    std::vector<std::pair<double, Index>> keys;
    for (Index i = 0; i < count; ++i) {
      const Pose &a = layout.poses[first], &b = layout.poses[i];
      const double distance = std::hypot(a.x - b.x, a.y - b.y) - shapes_[i].radius;
      keys.emplace_back(i == first ? -INFINITY : neighbours ? distance : unit(rng), i);
    }
    std::sort(keys.begin(), keys.end());
    std::vector<Index> some;
    for (std::size_t k = 0; k < wanted; ++k) some.push_back(keys[k].second);
    return some;
  }

  /// False, and given up early, when it falls behind `best`.
  bool squeeze(Chain& chain, std::span<const double> depths, int steps, const Chain* best) const {
    constexpr double kBehind = 1.004;
    // Shapes must shrink by about the depth over their radius to come apart.
    constexpr double kRadius = 0.2;
    Squeezer squeezer(shapes_, gaps_);
    for (const double depth : depths) {
      // The force that presses shapes in so deep.
      const double pressure = 4 * depth / 1024 * chain.layout.side;
      squeezer.run(chain.layout, {pressure, steps}, progress_);
      chain.sides.push_back(chain.layout.side);
      const std::size_t done = chain.sides.size();
      if (best != nullptr && chain.sides.back() > kBehind * best->sides[done - 1]) return false;
    }
    chain.side = chain.layout.side * (1 + squeezer.depth() / kRadius);
    return true;
  }

  std::span<const PackShape> shapes_;
  PackGaps gaps_;
  const Progress& progress_;
  int turns_;
};

}  // namespace

std::vector<PackLayout> searchLayouts(std::span<const PackShape> shapes, const PackGaps& gaps,
                                      double effort, float lastFraction, Progress& progress) {
  const Plan plan = planFor(shapes, effort);
  // A start costs about as much as three rounds.
  float work = 3 * static_cast<float>(plan.starts);
  for (const Plan::Stage& stage : plan.stages) {
    work += static_cast<float>(stage.chains) * static_cast<float>(stage.rounds);
  }
  std::atomic<int> done{0};
  const auto advance = [&](int rounds) {
    progress.setFraction(lastFraction * static_cast<float>(done += rounds) / work);
  };
  const Search search(shapes, gaps, progress);
  std::vector<Chain> chains(plan.starts);
  parallelFor(chains.size(), [&](std::size_t k) {
    if (progress.cancelled()) return;
    Rng rng(kSeed + static_cast<std::uint32_t>(k));
    chains[k] = search.start(rng);
    advance(3);
  });
  std::uint32_t seed = kSeed + 1000;
  for (const Plan::Stage& stage : plan.stages) {
    std::stable_sort(chains.begin(), chains.end(), denser);
    chains.resize(std::min(chains.size(), stage.chains));
    parallelFor(chains.size(), [&](std::size_t k) {
      Rng rng(seed + static_cast<std::uint32_t>(k));
      for (int i = 0; i < stage.rounds && !progress.cancelled(); ++i) {
        search.improve(chains[k], rng);
        advance(1);
      }
    });
    seed += 1000;
  }
  std::stable_sort(chains.begin(), chains.end(), denser);
  std::vector<PackLayout> layouts;
  for (Chain& chain : chains) layouts.push_back(std::move(chain.layout));
  return layouts;
}

}  // namespace chartflood
