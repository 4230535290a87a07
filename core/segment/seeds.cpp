#include "core/segment/seeds.h"

#include <algorithm>
#include <limits>
#include <queue>
#include <string>
#include <utility>

#include <glm/geometric.hpp>

#include "core/base/error.h"
#include "core/flood/build_flood_graph.h"
#include "core/flood/min_heap.h"

namespace chartflood {

namespace {

constexpr float kUnreached = std::numeric_limits<float>::infinity();

/// Faces sorted by component, ascending within each.
struct ComponentFaces {
  std::vector<Index> begin;  ///< of each component in `faces`, and the end
  std::vector<Index> faces;

  explicit ComponentFaces(const Mesh& mesh) : begin(mesh.componentCount() + 1, 0) {
    const auto component = mesh.faceComponent();
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
class SeedDistances {
 public:
  SeedDistances(const Mesh& mesh, const ComponentFaces& order)
      : mesh_(mesh), order_(order), centroid_(faceCentroids(mesh)),
        distance_(mesh.faceCount(), kUnreached), isSeed_(mesh.faceCount(), false),
        blockOf_(mesh.faceCount()) {
    for (std::size_t c = 0; c < mesh.componentCount(); ++c) {
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
    while (!heap_.empty()) {
      const TimedFace top = heap_.top();
      heap_.pop();
      const Index face = chartflood::faceOf(top);
      if (timeOf(top) != distance_[face]) continue;
      for (Index s = 3 * mesh_.triangleBegin(face); s < 3 * mesh_.triangleBegin(face + 1); ++s) {
        const Index opposite = mesh_.opposite()[s];
        if (opposite == kNone) continue;
        const Index next = mesh_.faceOf(opposite / 3);
        const double length = glm::length(centroid_[face] - centroid_[next]);
        const float there = timeOf(top) + static_cast<float>(length);
        if (there < distance_[next]) improve(next, there);
      }
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
    heap_.push(timedFace(distance, face));
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

  const Mesh& mesh_;
  const ComponentFaces& order_;
  std::vector<glm::dvec3> centroid_;
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
  SeedShares(const ComponentFaces& order, std::span<const double> weight)
      : order_(order), weight_(weight), seeds_(weight.size(), 0) {}

  void count(std::size_t component) { ++seeds_[component]; }
  void begin() {
    for (std::size_t c = 0; c < seeds_.size(); ++c) offer(c);
  }
  /// The component with the largest weight per seed that has a face to spare, lowest on ties.
  std::size_t next() {
    const std::size_t component = queue_.top().second;
    queue_.pop();
    count(component);
    offer(component);
    return component;
  }

 private:
  void offer(std::size_t component) {
    if (seeds_[component] >= order_.count(component)) return;
    queue_.emplace(weight_[component] / static_cast<double>(seeds_[component]), component);
  }
  struct LowestOnTies {
    using Share = std::pair<double, std::size_t>;
    bool operator()(const Share& a, const Share& b) const {
      return a.first != b.first ? a.first < b.first : a.second > b.second;
    }
  };

  const ComponentFaces& order_;
  std::span<const double> weight_;
  std::vector<std::size_t> seeds_;
  std::priority_queue<LowestOnTies::Share, std::vector<LowestOnTies::Share>, LowestOnTies> queue_;
};

void checkGiven(const Mesh& mesh, std::span<const Index> given) {
  std::vector<Index> sorted(given.begin(), given.end());
  std::sort(sorted.begin(), sorted.end());
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    if (sorted[i] >= mesh.faceCount()) {
      throw UsageError("Seed " + std::to_string(sorted[i]) +
                       " is no face of the mesh: faces are 0 to " +
                       std::to_string(mesh.faceCount() - 1) + ".");
    }
    if (i > 0 && sorted[i] == sorted[i - 1]) {
      throw UsageError("Seed " + std::to_string(sorted[i]) +
                       " is given twice: each chart needs a seed of its own.");
    }
  }
}

/// One random face in each component without a seed, components in their order.
void seedBareComponents(const Mesh& mesh, const ComponentFaces& order, Rng& rng,
                        std::vector<Index>& seeds) {
  std::vector<bool> seeded(mesh.componentCount(), false);
  for (const Index seed : seeds) seeded[mesh.faceComponent()[seed]] = true;
  for (std::size_t c = 0; c < seeded.size(); ++c) {
    if (seeded[c]) continue;
    const Index pick = rng.below(static_cast<std::uint32_t>(order.count(c)));
    seeds.push_back(order.faces[order.begin[c] + pick]);
  }
}

}  // namespace

std::size_t effectiveChartCount(const Mesh& mesh, std::size_t requested) {
  return std::min(std::max(requested, mesh.componentCount()), mesh.faceCount());
}

std::vector<Index> placeSeeds(const Mesh& mesh, std::size_t count, std::span<const Index> given,
                              std::span<const double> componentWeight, Rng& rng) {
  checkGiven(mesh, given);
  std::vector<Index> seeds(given.begin(), given.end());
  if (seeds.empty()) seeds.push_back(rng.below(static_cast<std::uint32_t>(mesh.faceCount())));
  const ComponentFaces order(mesh);
  seedBareComponents(mesh, order, rng, seeds);
  if (seeds.size() >= count) return seeds;
  SeedDistances distances(mesh, order);
  SeedShares shares(order, componentWeight);
  for (const Index seed : seeds) {
    distances.add(seed);
    shares.count(mesh.faceComponent()[seed]);
  }
  shares.begin();
  while (seeds.size() < count) {
    seeds.push_back(distances.farthest(shares.next()));
    distances.add(seeds.back());
  }
  return seeds;
}

}  // namespace chartflood
