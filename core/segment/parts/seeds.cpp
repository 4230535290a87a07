#include "core/segment/parts/seeds.h"

#include <algorithm>
#include <string>
#include <utility>

#include <glm/geometric.hpp>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/flood/build_flood_graph.h"
#include "core/segment/parts/seed_spread.h"

namespace chartflood {

namespace {

constexpr std::size_t kSideBlock = 1 << 15;

/// Neighbours of faces with the distances between centroids.
class FaceDual {
 public:
  explicit FaceDual(const Mesh& mesh) : mesh_(mesh) {}

  template <class Visit>
  void forNeighbours(Index face, const Visit& visit) const {
    // Made when it is first asked for: given seeds may be all there are.
    if (ways_.empty()) findWays();
    for (Index s = 3 * mesh_.triangleBegin(face); s < 3 * mesh_.triangleBegin(face + 1); ++s) {
      const Way& way = ways_[s];
      if (way.next != kNone) visit(way.next, way.length);
    }
  }

 private:
  /// Across a side of a triangle; inside a face it leads nowhere.
  struct Way {
    Index next = kNone;
    float length = 0;
  };

  void findWays() const {
    const std::vector<glm::dvec3> centroid = faceCentroids(mesh_);
    ways_.resize(mesh_.opposite().size());
    parallelBlocks(ways_.size(), kSideBlock, [&](std::size_t begin, std::size_t end) {
      for (std::size_t s = begin; s < end; ++s) {
        const Index opposite = mesh_.opposite()[s];
        if (opposite == kNone) continue;
        const Index face = mesh_.faceOf(static_cast<Index>(s / 3));
        const Index next = mesh_.faceOf(opposite / 3);
        if (next == face) continue;
        ways_[s] = {next, static_cast<float>(glm::length(centroid[face] - centroid[next]))};
      }
    });
  }

  const Mesh& mesh_;
  mutable std::vector<Way> ways_;  ///< of all sides of triangles
};

}  // namespace

std::size_t effectiveChartCount(const Mesh& mesh, std::size_t requested, std::size_t seeds) {
  return std::min(std::max(countWithParts(mesh, requested).charts, seeds), mesh.faceCount());
}

void checkSeeds(const Mesh& mesh, std::span<const Index> given) {
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

std::vector<Index> placeSeeds(const Mesh& mesh, std::size_t count, std::span<const Index> given,
                              const PartShares& shares, Rng& rng) {
  checkSeeds(mesh, given);
  return spreadSeeds(FaceDual(mesh), mesh.faceComponent(), mesh.componentCount(), count, given,
                     shares, rng);
}

std::size_t seedsToAdd(std::size_t present, std::size_t wanted) {
  return std::min(wanted - present, std::max<std::size_t>(1, present / 32));
}

}  // namespace chartflood
