#include "core/segment/seeds.h"

#include <algorithm>
#include <limits>
#include <string>

#include <glm/geometric.hpp>

#include "core/base/error.h"
#include "core/flood/build_flood_graph.h"
#include "core/flood/min_heap.h"

namespace chartflood {

namespace {

constexpr float kUnreached = std::numeric_limits<float>::infinity();

/// Distance of every face to the nearest seed, with the largest of each block of faces at hand.
class SeedDistances {
 public:
  explicit SeedDistances(const Mesh& mesh)
      : mesh_(mesh), centroid_(faceCentroids(mesh)), distance_(mesh.faceCount(), kUnreached),
        isSeed_(mesh.faceCount(), false), blocks_((mesh.faceCount() + kBlock - 1) / kBlock) {}

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

  /// Lowest of the farthest faces that are no seeds.
  Index farthest() {
    Index best = kNone;
    float bestDistance = -1;
    for (std::size_t b = 0; b < blocks_.size(); ++b) {
      if (blocks_[b].stale) scan(b);
      if (blocks_[b].face != kNone && blocks_[b].distance > bestDistance) {
        best = blocks_[b].face;
        bestDistance = blocks_[b].distance;
      }
    }
    return best;
  }

 private:
  static constexpr std::size_t kBlock = 1024;
  struct Block {
    float distance = -1;
    Index face = kNone;  ///< lowest farthest face of the block that is no seed
    bool stale = true;
  };

  void improve(Index face, float distance) {
    distance_[face] = distance;
    blocks_[face / kBlock].stale = true;
    heap_.push(timedFace(distance, face));
  }
  void scan(std::size_t b) {
    Block block{-1, kNone, false};
    const std::size_t end = std::min((b + 1) * kBlock, distance_.size());
    for (std::size_t f = b * kBlock; f < end; ++f) {
      if (isSeed_[f] || !(distance_[f] > block.distance)) continue;
      block.distance = distance_[f];
      block.face = static_cast<Index>(f);
    }
    blocks_[b] = block;
  }

  const Mesh& mesh_;
  std::vector<glm::dvec3> centroid_;
  std::vector<float> distance_;
  std::vector<bool> isSeed_;
  std::vector<Block> blocks_;
  MinHeap heap_;
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
void seedBareComponents(const Mesh& mesh, Rng& rng, std::vector<Index>& seeds) {
  const auto component = mesh.faceComponent();
  std::vector<bool> seeded(mesh.componentCount(), false);
  for (const Index seed : seeds) seeded[component[seed]] = true;
  if (std::find(seeded.begin(), seeded.end(), false) == seeded.end()) return;
  std::vector<Index> begin(mesh.componentCount() + 1, 0);
  for (const Index c : component) ++begin[c + 1];
  for (std::size_t c = 0; c < mesh.componentCount(); ++c) begin[c + 1] += begin[c];
  std::vector<Index> next(begin.begin(), begin.end() - 1), members(component.size());
  for (Index f = 0; f < component.size(); ++f) members[next[component[f]]++] = f;
  for (std::size_t c = 0; c < mesh.componentCount(); ++c) {
    if (!seeded[c]) seeds.push_back(members[begin[c] + rng.below(begin[c + 1] - begin[c])]);
  }
}

}  // namespace

std::size_t effectiveChartCount(const Mesh& mesh, std::size_t requested) {
  return std::min(std::max(requested, mesh.componentCount()), mesh.faceCount());
}

std::vector<Index> placeSeeds(const Mesh& mesh, std::size_t count, std::span<const Index> given,
                              Rng& rng) {
  checkGiven(mesh, given);
  std::vector<Index> seeds(given.begin(), given.end());
  if (seeds.empty()) seeds.push_back(rng.below(static_cast<std::uint32_t>(mesh.faceCount())));
  seedBareComponents(mesh, rng, seeds);
  if (seeds.size() >= count) return seeds;
  SeedDistances distances(mesh);
  for (const Index seed : seeds) distances.add(seed);
  while (seeds.size() < count) {
    seeds.push_back(distances.farthest());
    distances.add(seeds.back());
  }
  return seeds;
}

}  // namespace chartflood
