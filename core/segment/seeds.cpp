#include "core/segment/seeds.h"

#include <algorithm>
#include <string>
#include <utility>

#include <glm/geometric.hpp>

#include "core/base/error.h"
#include "core/flood/build_flood_graph.h"
#include "core/segment/seed_spread.h"

namespace chartflood {

namespace {

/// Neighbours of faces with the distances between centroids.
class FaceDual {
 public:
  explicit FaceDual(const Mesh& mesh) : mesh_(mesh) {}

  template <class Visit>
  void forNeighbours(Index face, const Visit& visit) const {
    // Made when it is first asked for: given seeds may be all there are.
    if (centroid_.empty()) centroid_ = faceCentroids(mesh_);
    for (Index s = 3 * mesh_.triangleBegin(face); s < 3 * mesh_.triangleBegin(face + 1); ++s) {
      const Index opposite = mesh_.opposite()[s];
      if (opposite == kNone) continue;
      const Index next = mesh_.faceOf(opposite / 3);
      visit(next, glm::length(centroid_[face] - centroid_[next]));
    }
  }

 private:
  const Mesh& mesh_;
  mutable std::vector<glm::dvec3> centroid_;
};

}  // namespace

std::size_t effectiveChartCount(const Mesh& mesh, std::size_t requested) {
  return std::min(std::max(requested, mesh.componentCount()), mesh.faceCount());
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
                              std::span<const double> componentWeight, Rng& rng) {
  checkSeeds(mesh, given);
  return spreadSeeds(FaceDual(mesh), mesh.faceComponent(), mesh.componentCount(), count, given,
                     componentWeight, rng);
}

}  // namespace chartflood
