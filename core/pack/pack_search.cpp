#include "core/pack/pack_search.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <iterator>
#include <numbers>

#include "core/base/parallel.h"
#include "core/base/rng.h"
#include "core/pack/free_space.h"

namespace chartflood {

namespace {

/// Shares of the square that the charts and the gaps around them should cover when they are placed
/// one by one, start after start: more than they can, so that squeezing begins with charts that
/// overlap a little.
constexpr double kFirstFills[] = {0.84, 0.87, 0.82, 0.855};
/// Where charts stay hooked into each other, the next try leaves more room, down to this share.
constexpr double kLeastFill = 0.08, kLessFill = 0.8;
/// Room that many charts do not fill stays a hole in their middle: they are given little more.
constexpr double kLessFillOfMany = 0.93;
/// Many charts are placed once more, among finer cells, where so deep in each other that they will
/// cover less once they are apart. Others cover 0.28 even while some of them hook, heaps 0.06.
constexpr double kPoorFill = 0.2;
/// How deep charts lie in each other that are hooked, in grains, and how much
/// smaller they must become at the end to come apart.
constexpr double kHookedDepth = 2, kHookedCost = 1.5;
/// One in so many charts may be hooked where it is worth while to take those out.
constexpr std::ptrdiff_t kHookedShare = 8;
/// How deep charts lie in each other, in grains, where they were put on one heap; otherwise they
/// begin with 15 to 75. And how many cannot make one that matters.
constexpr double kPiledDepth = 90;
constexpr std::size_t kFewCharts = 60;
/// Among many charts so much is not made good at the end any more.
constexpr double kStuckDepth = 0.5;
/// Turns tried for every chart that is placed; fewer where there are many charts, and always in
/// eights, so that boxes lie upright or along the diagonal, or four.
constexpr int kTurns = 24;
/// Sides of the cells in which places are looked for, layout units.
constexpr double kCell = 0.0155, kCoarseCell = 0.025;
/// Share of the square's side from which a shape counts as large.
constexpr double kLarge = 0.8;
constexpr int kRepairs = 4, kRepairsOfMany = 2;
constexpr int kStartSteps = 60, kRoundSteps = 40;
constexpr std::uint32_t kSeed = 1;
/// Depths, in grains, that the walls press charts into each other, softest
/// last.
constexpr double kStartDepths[] = {4, 0.5, 0.0625};
constexpr double kRoundDepths[] = {2, 0.25, 0.03125};
constexpr double kGentleDepths[] = {0.5, 0.25, 0.03125};  // among many charts

/// How much is tried; points of outlines times steps of squeezing are what it costs.
struct Plan {
  std::size_t starts;
  struct Stage {
    std::size_t chains;
    int rounds;
  };
  std::vector<Stage> stages;
};

Plan planFor(std::span<const PackShape> shapes) {
  double points = 0;
  for (const PackShape& shape : shapes) points += static_cast<double>(shape.points.size());
  // A square of twenty usual charts has about 2500 points.
  const double less = std::min(1.0, 2500 / points);
  const auto rounds = [&](double most) { return 2 + static_cast<int>(most * less); };
  // Among many charts a few that lie better change little.
  if (shapes.size() > kManyCharts) return {2, {}};
  return {shapes.size() > 60 ? 4u : 8u, {{4, rounds(8)}, {2, rounds(26)}}};
}

double unit(Rng& rng) { return (rng.below(1u << 24) + 0.5) / (1u << 24); }

/// A layout that was squeezed, or was given up on the way.
struct Squeezed {
  PackLayout layout;
  double side = 0;            ///< of the layout, what is still pressed in made good
  std::vector<double> sides;  ///< after each depth of squeezing, what is pressed in counted
};

bool denser(const Squeezed& a, const Squeezed& b) { return a.side < b.side; }

/// When to look whether a layout that is squeezed falls behind, and when it does. After a fifth of
/// the steps half of those that come to nothing are found, and one in twenty of the others.
struct Look {
  double share;   ///< of the steps
  double behind;  ///< sides over that of the layout to better
};
constexpr Look kLooks[] = {{0.2, 1.02}, {0.5, 1.007}, {1, 1.0015}};

class Search {
 public:
  Search(std::span<const PackShape> shapes, const PackGaps& gaps, double largestSide,
         const Progress& progress)
      : shapes_(shapes), gaps_(gaps), largestSide_(largestSide), progress_(progress),
        turns_(std::clamp(static_cast<int>(60 * kTurns / shapes.size()) / 8 * 8,
                          shapes.size() > kManyCharts ? 4 : 8, kTurns)),
        cell_(shapes.size() <= 60 ? kCell : kCoarseCell) {}

  Squeezed start(double firstFill, Rng& rng) const {
    std::vector<Index> all(shapes_.size());
    for (Index i = 0; i < all.size(); ++i) all[i] = i;
    Squeezer squeezer(shapes_, gaps_);
    Squeezed best{{}, INFINITY, {}};
    // Between wide gaps the cells are fine enough, and what is placed leaves less of a hole.
    const bool wide = gaps_.between * sideFor(firstFill) >= cell_;
    const double less = many() && !wide ? kLessFillOfMany : kLessFill;
    double cell = cell_;
    for (double fill = firstFill; fill > kLeastFill && !progress_.cancelled(); fill *= less) {
      const double side = sideFor(fill);
      if (fill < firstFill && side > largestSide_ && best.side < INFINITY) break;
      Squeezed next{{side, std::vector<Pose>(shapes_.size())}, 0, {}};
      FreeSpace space = emptySpace(side, cell);
      place(next.layout, space, largeFirst(all, 0.3, rng), rng);
      if (piled(next.layout, squeezer)) {
        // The smallest of charts of many sizes find no place among cells larger than they are.
        if (cell > kCell && !wide) cell = kCell, fill /= less;
        continue;
      }
      squeeze(next, squeezer, kStartDepths, kStartSteps, nullptr);
      const int repairs = many() ? kRepairsOfMany : kRepairs;
      for (int i = 0; i < repairs && worthRepair(next.layout, squeezer); ++i) {
        unhook(next, squeezer, rng);
      }
      if (denser(next, best)) best = std::move(next);
      if (many() && cell > kCell && best.side > sideFor(kPoorFill)) {
        cell = kCell, fill /= less;
        continue;
      }
      // Among many the few that still hook are parted at the end.
      if (!hooked(best.layout, squeezer) || many()) break;
    }
    return best;
  }

  static void scale(PackLayout& layout, double factor) {
    layout.side *= factor;
    for (Pose& pose : layout.poses) pose.x *= factor, pose.y *= factor;
  }

  /// Takes out what lies too deep in others and looks for other places for it.
  void unhook(Squeezed& next, Squeezer& squeezer, Rng& rng) const {
    constexpr double kRoomier = 1.01;
    const double most = repairDepth() * grainOf(next.layout.side, shapes_.size());
    scale(next.layout, kRoomier);
    FreeSpace space = emptySpace(next.layout.side);
    std::vector<Index> taken;
    for (Index i = 0; i < shapes_.size(); ++i) {
      if (squeezer.depths()[i] > most)
        taken.push_back(i);
      else
        space.add(space.footprint(shapes_[i], next.layout.poses[i]));
    }
    place(next.layout, space, largeFirst(taken, 0, rng), rng);
    next.sides.clear();
    squeeze(next, squeezer, many() ? kGentleDepths : kRoundDepths, kRoundSteps, nullptr);
  }

  /// A layout on its way to a denser one.
  class Chain {
   public:
    Chain(const Search& search, Squeezed& best, Rng rng)
        : search_(search), best_(best), rng_(rng), squeezer_(search.shapes_, search.gaps_) {
      // What rounds are compared with was squeezed as they are.
      Squeezed again{best.layout, 0, {}};
      search.squeeze(again, squeezer_, kRoundDepths, kRoundSteps, nullptr);
      if (denser(again, best)) best.layout = again.layout, best.side = again.side;
      best.sides = again.sides;
      tighten();
    }

    /// Takes some shapes out and puts them back in; keeps the result when it is denser.
    void improve() {
      Squeezed next{tight_, 0, {}};
      const std::vector<Index> taken = search_.someShapes(best_.layout, rng_);
      FreeSpace space = search_.emptySpace(tight_.side);
      for (Index i = 0; i < footprints_.size(); ++i) {
        if (std::find(taken.begin(), taken.end(), i) == taken.end()) space.add(footprints_[i]);
      }
      search_.place(next.layout, space, search_.largeFirst(taken, 0.5, rng_), rng_);
      if (search_.squeeze(next, squeezer_, kRoundDepths, kRoundSteps, &best_) &&
          denser(next, best_)) {
        best_ = std::move(next);
        tighten();
      }
    }

   private:
    /// Tighter than it was, so that only better places fit.
    void tighten() {
      constexpr double kTighter = 0.99;
      tight_ = best_.layout;
      scale(tight_, kTighter);
      const FreeSpace space = search_.emptySpace(tight_.side);
      footprints_.clear();
      for (std::size_t i = 0; i < tight_.poses.size(); ++i) {
        footprints_.push_back(space.footprint(search_.shapes_[i], tight_.poses[i]));
      }
    }

    const Search& search_;
    Squeezed& best_;
    Rng rng_;
    Squeezer squeezer_;
    PackLayout tight_;
    std::vector<Footprint> footprints_;  ///< of the tight layout
  };

 private:
  /// The side of a square of which shapes and the halves of gaps around them are that share, and
  /// which holds each of them.
  double sideFor(double fill) const {
    double area = 0, around = 0;
    for (const PackShape& shape : shapes_) area += shape.area, around += shape.around;
    const double gaps = around * gaps_.between / 2;
    const double byArea = (gaps + std::sqrt(gaps * gaps + 4 * fill * area)) / (2 * fill);
    double largest = 0;
    for (const PackShape& shape : shapes_) largest = std::max(largest, shape.square);
    return std::max(byArea, largest / (1 - 2 * gaps_.border));
  }

  FreeSpace emptySpace(double side) const { return emptySpace(side, cell_); }
  FreeSpace emptySpace(double side, double cell) const {
    return {side, gaps_.between * side, gaps_.border * side, cell};
  }

  /// Large shapes first, in an order that differs from time to time.
  std::vector<Index> largeFirst(const std::vector<Index>& some, double disorder, Rng& rng) const {
    std::vector<std::pair<double, Index>> keys;
    for (const Index i : some) {
      const double size = std::log(static_cast<double>(shapes_[i].area) + 1e-12);
      keys.emplace_back(disorder * (2 * unit(rng) - 1) - size, i);
    }
    std::sort(keys.begin(), keys.end());
    std::vector<Index> order;
    order.reserve(keys.size());
    for (const auto& [key, i] : keys) order.push_back(i);
    return order;
  }

  void place(PackLayout& layout, FreeSpace& space, const std::vector<Index>& order,
             Rng& rng) const {
    for (const Index i : order) {
      if (progress_.cancelled()) return;
      const double any = 2 * std::numbers::pi * unit(rng);
      // What hardly fits does so at one turn.
      const bool large = shapes_[i].square > kLarge * layout.side;
      const double first = large ? shapes_[i].inSquare : shapes_[i].boxy ? shapes_[i].upright : any;
      layout.poses[i] = space.bestPose(shapes_[i], first, turns_);
      space.add(space.footprint(shapes_[i], layout.poses[i]));
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

  /// Whether there was no room for the last ones, which then lie on one heap: nothing parts them,
  /// and squeezing a heap takes a hundred times as long. A few charts lie on each other in any
  /// case.
  bool piled(PackLayout layout, Squeezer& squeezer) const {
    if (shapes_.size() <= kFewCharts) return false;
    squeezer.rest();
    squeezer.run(layout, {pressureFor(kStartDepths[0], layout.side), 1}, progress_);
    return deeper(kPiledDepth, layout, squeezer);
  }

  /// Whether thin shapes lie across each other, which no pressing takes apart.
  static bool hooked(const PackLayout& layout, const Squeezer& squeezer) {
    return deeper(kHookedDepth, layout, squeezer);
  }
  static bool deeper(double grains, const PackLayout& layout, const Squeezer& squeezer) {
    return squeezer.depth() > grains * grainOf(layout.side, layout.poses.size());
  }
  /// Whether some shapes lie too deep in others, yet not so many that only more room helps.
  bool worthRepair(const PackLayout& layout, const Squeezer& squeezer) const {
    if (!deeper(repairDepth(), layout, squeezer)) return false;
    const double most = kHookedDepth * grainOf(layout.side, shapes_.size());
    const std::span<const float> depths = squeezer.depths();
    const auto hooked =
        std::count_if(depths.begin(), depths.end(), [&](float depth) { return depth > most; });
    return shapes_.size() <= kFewCharts || hooked <= std::ssize(depths) / kHookedShare;
  }
  bool many() const { return shapes_.size() > kManyCharts; }
  double repairDepth() const { return many() ? kStuckDepth : kHookedDepth; }

  /// False, and given up early, when it falls behind `best`.
  bool squeeze(Squeezed& next, Squeezer& squeezer, std::span<const double> depths, int steps,
               const Squeezed* best) const {
    // Shapes must shrink by about the depth over their radius to come apart.
    constexpr double kRadius = 0.2;
    for (const double depth : depths) {
      const double pressure = pressureFor(depth, next.layout.side);
      squeezer.rest();
      const bool soft = depth == depths.front();
      int done = 0;
      for (const Look& look : kLooks) {
        // Where charts are pressed into each other too deep for the pressure nothing is known yet.
        if (!soft && look.share < 1) continue;
        const int until = static_cast<int>(look.share * steps);
        squeezer.run(next.layout, {pressure, until - done}, progress_);
        done = until;
        // What the walls could still give while shapes are pressed out of each other.
        const double side = next.layout.side + squeezer.energy() / pressure;
        if (look.share == 1) next.sides.push_back(side);
        const std::size_t at = next.sides.size() - (look.share == 1 ? 1 : 0);
        if (best != nullptr && side > look.behind * best->sides[at]) return false;
      }
    }
    next.side = next.layout.side * (1 + squeezer.depth() / kRadius);
    if (hooked(next.layout, squeezer)) next.side *= kHookedCost;
    return true;
  }

  std::span<const PackShape> shapes_;
  PackGaps gaps_;
  double largestSide_;
  const Progress& progress_;
  int turns_;
  double cell_;  ///< of the free space, layout units
};

}  // namespace

std::vector<PackLayout> searchLayouts(std::span<const PackShape> shapes, const PackGaps& gaps,
                                      double largestSide, float lastFraction, Progress& progress) {
  const Plan plan = planFor(shapes);
  // A start costs about as much as three rounds.
  float work = 3 * static_cast<float>(plan.starts);
  for (const Plan::Stage& stage : plan.stages) {
    work += static_cast<float>(stage.chains) * static_cast<float>(stage.rounds);
  }
  std::atomic<int> done{0};
  const auto advance = [&](int rounds) {
    progress.setFraction(lastFraction * static_cast<float>(done += rounds) / work);
  };
  const Search search(shapes, gaps, largestSide, progress);
  std::vector<Squeezed> chains(plan.starts);
  parallelFor(chains.size(), [&](std::size_t k) {
    if (progress.cancelled()) return;
    Rng rng(kSeed + static_cast<std::uint32_t>(k));
    chains[k] = search.start(kFirstFills[k % std::size(kFirstFills)], rng);
    advance(3);
  });
  std::uint32_t seed = kSeed + 1000;
  for (const Plan::Stage& stage : plan.stages) {
    std::stable_sort(chains.begin(), chains.end(), denser);
    chains.resize(std::min(chains.size(), stage.chains));
    parallelFor(chains.size(), [&](std::size_t k) {
      Search::Chain chain(search, chains[k], Rng(seed + static_cast<std::uint32_t>(k)));
      for (int i = 0; i < stage.rounds && !progress.cancelled(); ++i) {
        chain.improve();
        advance(1);
      }
    });
    seed += 1000;
  }
  std::stable_sort(chains.begin(), chains.end(), denser);
  std::vector<PackLayout> layouts;
  layouts.reserve(chains.size());
  for (Squeezed& chain : chains) layouts.push_back(std::move(chain.layout));
  return layouts;
}

}  // namespace chartflood
