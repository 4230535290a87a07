#pragma once
/// Seeds far apart from each other over any dual graph: of faces or of clusters of them. The rules
/// are those of placeSeeds().

#include <algorithm>
#include <limits>
#include <queue>
#include <span>
#include <utility>
#include <vector>

#include "core/base/index.h"
#include "core/base/rng.h"
#include "core/flood/min_heap.h"
#include "core/segment/parts/part_shares.h"

namespace chartflood {

/// Faces sorted by component, ascending within each.
struct ComponentFaces {
  std::vector<Index> begin;  ///< of each component in `faces`, and the end
  std::vector<Index> faces;

  ComponentFaces(std::span<const Index> component, std::size_t components)
      : begin(components + 1, 0) {
    for (const Index c : component) ++begin[c + 1];
    for (std::size_t c = 0; c + 1 < begin.size(); ++c) begin[c + 1] += begin[c];
    std::vector<Index> next(begin.begin(), begin.end() - 1);
    faces.resize(component.size());
    for (Index f = 0; f < component.size(); ++f) faces[next[component[f]]++] = f;
  }
  std::size_t count(std::size_t component) const { return begin[component + 1] - begin[component]; }
};

/// Distance of every face to the nearest seed, with the largest of each block of faces at hand.
/// Blocks never span components.
template <class Dual>
class SeedDistances {
 public:
  SeedDistances(const Dual& dual, const ComponentFaces& order)
      : dual_(dual), order_(order), distance_(order.faces.size(), kUnreached),
        isSeed_(order.faces.size(), false), blockOf_(order.faces.size()) {
    for (std::size_t c = 0; c + 1 < order.begin.size(); ++c) {
      firstBlock_.push_back(blocks_.size());
      for (Index i = order.begin[c]; i < order.begin[c + 1]; ++i) {
        if ((i - order.begin[c]) % kBlock == 0) {
          blocks_.push_back({.begin = i, .end = std::min(i + kBlock, order.begin[c + 1])});
        }
        blockOf_[order.faces[i]] = static_cast<Index>(blocks_.size() - 1);
      }
    }
    firstBlock_.push_back(blocks_.size());
  }

  /// Dijkstra from the new seed, pruned where it brings nothing nearer.
  void add(Index seed) {
    isSeed_[seed] = true;
    improve(seed, 0.0f);
    heap_.push(timedFace(0.0f, seed));
    while (!heap_.empty()) {
      const TimedFace top = heap_.top();
      const Index face = chartflood::faceOf(top);
      if (timeOf(top) != distance_[face]) {  // reached on a shorter way meanwhile
        heap_.pop();
        continue;
      }
      bool replaced = false;
      dual_.forNeighbours(face, [&](Index next, float length) {
        const float there = timeOf(top) + length;
        if (there >= distance_[next]) return;
        improve(next, there);
        const TimedFace entry = timedFace(there, next);
        replaced ? heap_.push(entry) : heap_.replaceTop(entry);
        replaced = true;
      });
      if (!replaced) heap_.pop();
    }
  }

  /// Lowest of the component's farthest faces that are no seeds.
  Index farthest(std::size_t component) {
    Index best = kNone;
    float bestDistance = -1;
    for (std::size_t b = firstBlock_[component]; b < firstBlock_[component + 1]; ++b) {
      if (blocks_[b].stale) scan(blocks_[b]);
      if (blocks_[b].face != kNone && blocks_[b].distance > bestDistance) {
        best = blocks_[b].face;
        bestDistance = blocks_[b].distance;
      }
    }
    return best;
  }

 private:
  static constexpr Index kBlock = 1024;
  struct Block {
    Index begin, end;  ///< in the order by component
    float distance = -1;
    Index face = kNone;  ///< lowest farthest face of the block that is no seed
    bool stale = true;
  };

  void improve(Index face, float distance) {
    distance_[face] = distance;
    blocks_[blockOf_[face]].stale = true;
  }
  void scan(Block& block) {
    block.distance = -1;
    block.face = kNone;
    block.stale = false;
    for (Index i = block.begin; i < block.end; ++i) {
      const Index face = order_.faces[i];
      if (isSeed_[face] || !(distance_[face] > block.distance)) continue;
      block.distance = distance_[face];
      block.face = face;
    }
  }

  static constexpr float kUnreached = std::numeric_limits<float>::infinity();

  const Dual& dual_;
  const ComponentFaces& order_;
  std::vector<float> distance_;
  std::vector<bool> isSeed_;
  std::vector<Index> blockOf_;
  std::vector<std::size_t> firstBlock_;  ///< of each component, and the end
  std::vector<Block> blocks_;
  MinHeap heap_;
};

/// Says which component gets the next seed.
class SeedShares {
 public:
  SeedShares(const ComponentFaces& order, const PartShares& shares)
      : order_(order), shares_(shares), seeds_(shares.weight.size(), 0) {}

  void count(std::size_t component) { ++seeds_[component]; }
  void begin() {
    for (std::size_t c = 0; c < seeds_.size(); ++c) offer(c);
  }
  /// The component with the largest weight per seed that has a face to spare, lowest on ties; those
  /// with all they may have come last.
  std::size_t next() {
    const std::size_t component = queue_.top().component;
    queue_.pop();
    count(component);
    offer(component);
    return component;
  }

 private:
  void offer(std::size_t component) {
    if (seeds_[component] >= order_.count(component)) return;
    const std::size_t seeds = seeds_[component];
    const bool full = !shares_.most.empty() && seeds >= shares_.most[component];
    const double weight = shares_.weight[component] / static_cast<double>(seeds);
    queue_.push({full, weight, component});
  }
  struct Share {
    bool full;
    double weight;
    std::size_t component;
  };
  struct LowestOnTies {
    bool operator()(const Share& a, const Share& b) const {
      if (a.full != b.full) return a.full;
      return a.weight != b.weight ? a.weight < b.weight : a.component > b.component;
    }
  };

  const ComponentFaces& order_;
  const PartShares& shares_;
  std::vector<std::size_t> seeds_;
  std::priority_queue<Share, std::vector<Share>, LowestOnTies> queue_;
};

/// One random face in each component without a seed, components in their order.
inline void seedBareComponents(std::span<const Index> component, const ComponentFaces& order,
                               Rng& rng, std::vector<Index>& seeds) {
  std::vector<bool> seeded(order.begin.size() - 1, false);
  for (const Index seed : seeds) seeded[component[seed]] = true;
  for (std::size_t c = 0; c < seeded.size(); ++c) {
    if (seeded[c]) continue;
    const Index pick = rng.below(static_cast<std::uint32_t>(order.count(c)));
    seeds.push_back(order.faces[order.begin[c] + pick]);
  }
}

/// Adds seeds to the given ones until there are `count`. `dual.forNeighbours(face, visit)` calls
/// visit(neighbour, distance). \pre the given seeds are distinct faces; `count` is at least the
/// number of components and at most that of faces
template <class Dual>
std::vector<Index> spreadSeeds(const Dual& dual, std::span<const Index> component,
                               std::size_t components, std::size_t count,
                               std::span<const Index> given, const PartShares& weights, Rng& rng) {
  std::vector<Index> seeds(given.begin(), given.end());
  if (seeds.empty()) seeds.push_back(rng.below(static_cast<std::uint32_t>(component.size())));
  const ComponentFaces order(component, components);
  seedBareComponents(component, order, rng, seeds);
  if (seeds.size() >= count) return seeds;
  SeedDistances<Dual> distances(dual, order);
  SeedShares shares(order, weights);
  for (const Index seed : seeds) {
    distances.add(seed);
    shares.count(component[seed]);
  }
  shares.begin();
  while (seeds.size() < count) {
    seeds.push_back(distances.farthest(shares.next()));
    distances.add(seeds.back());
  }
  return seeds;
}

}  // namespace chartflood
