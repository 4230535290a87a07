#include "core/segment/creases/flat_regions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include <glm/geometric.hpp>

#include "core/segment/creases/region_graph.h"

namespace chartflood {

namespace {

constexpr double kSine = 0.0087;         // half a degree
constexpr double kLift = 1e-4;           // normalised units beside the plane
constexpr double kSliver = 1e-5;         // what rounding may tilt a thin triangle by
constexpr std::size_t kManyPlanes = 60;  // regions from which a model is not made of planes
constexpr double kMostJoining = 4e6;     // regions times joins
constexpr double kLeastSquare = 0.95;    // cosine in a quad's corner that is too sharp

/// Twice the area of a face in the direction of its normal.
glm::dvec3 faceVector(const Mesh& mesh, Index face) {
  glm::dvec3 sum(0);
  const auto p = mesh.positions();
  for (Index t = mesh.triangleBegin(face); t < mesh.triangleBegin(face + 1); ++t) {
    const auto& [a, b, c] = mesh.triangles()[t];
    sum += glm::cross(p[b] - p[a], p[c] - p[a]);
  }
  return sum;
}

/// A region as it grows: the mean plane of its faces.
class GrowingPlane {
 public:
  GrowingPlane(const Mesh& mesh, Index face) : mesh_(mesh) { add(face, faceVector(mesh, face)); }

  /// Whether a face lies in the plane, turned the same way. A face without area does where its
  /// corners do.
  bool holds(Index face, const glm::dvec3& vector) const {
    const double length = glm::length(vector), own = glm::length(sum_);
    if (!(own > 0)) return false;
    const glm::dvec3 normal = sum_ / own;
    double longest = 0;
    for (Index s = 3 * mesh_.triangleBegin(face); s < 3 * mesh_.triangleBegin(face + 1); ++s) {
      const glm::dvec3& corner = mesh_.positions()[mesh_.sideStart(s)];
      if (std::abs(glm::dot(corner - origin_, normal)) > kLift) return false;
      longest = std::max(longest, glm::length(mesh_.positions()[mesh_.sideEnd(s)] - corner));
    }
    if (!(length > 0)) return true;
    if (!(glm::dot(vector, normal) > 0)) return false;
    const double height = length / longest;
    const double sine = glm::length(glm::cross(vector / length, normal));
    return sine * height <= std::max(kSine * height, kSliver);
  }
  void add(Index face, const glm::dvec3& vector) {
    const double weight = glm::length(vector);
    const glm::dvec3& corner = mesh_.positions()[mesh_.sideStart(3 * mesh_.triangleBegin(face))];
    origin_ =
        weight_ + weight > 0 ? (origin_ * weight_ + corner * weight) / (weight_ + weight) : corner;
    weight_ += weight;
    sum_ += vector;
  }

 private:
  const Mesh& mesh_;
  glm::dvec3 sum_{0}, origin_{0};
  double weight_ = 0;
};

/// Grows the region of a face over all that lie in its plane.
void growFlat(const Mesh& mesh, Index start, Index number, std::vector<Index>& label,
              std::vector<Index>& queue) {
  GrowingPlane plane(mesh, start);
  label[start] = number;
  queue.assign(1, start);
  for (std::size_t i = 0; i < queue.size(); ++i) {
    const Index f = queue[i];
    for (Index s = 3 * mesh.triangleBegin(f); s < 3 * mesh.triangleBegin(f + 1); ++s) {
      if (mesh.opposite()[s] == kNone) continue;
      const Index g = mesh.faceOf(mesh.opposite()[s] / 3);
      if (label[g] != kNone) continue;
      const glm::dvec3 vector = faceVector(mesh, g);
      if (!plane.holds(g, vector)) continue;
      plane.add(g, vector);
      label[g] = number;
      queue.push_back(g);
    }
  }
}

/// Of the quad of the two triangles at a side: the largest cosine in its corners, in size; more
/// than 1 where it is not convex.
double squareness(const Mesh& mesh, Index side) {
  const Index other = mesh.opposite()[side];
  const auto p = mesh.positions();
  const std::array<glm::dvec3, 4> corner = {
      p[mesh.sideEnd(side)], p[mesh.sideStart(Mesh::previousSide(side))], p[mesh.sideStart(side)],
      p[mesh.sideStart(Mesh::previousSide(other))]};
  const glm::dvec3 normal = glm::cross(corner[2] - corner[0], corner[3] - corner[1]);
  double worst = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const glm::dvec3 a = corner[(i + 1) % 4] - corner[i], b = corner[(i + 3) % 4] - corner[i];
    const double lengths = glm::length(a) * glm::length(b);
    if (!(glm::dot(glm::cross(a, b), normal) > 0)) return 2;
    worst = std::max(worst, std::abs(glm::dot(a, b)) / lengths);
  }
  return worst;
}

/// Too many regions would be joined one after the other.
bool takesLong(std::size_t regions, std::size_t charts) {
  const double joins = regions > charts ? static_cast<double>(regions - charts) : 0;
  return static_cast<double>(regions) * joins > kMostJoining;
}

std::optional<CreaseRegions> fittingRegions(const Mesh& mesh, std::size_t charts) {
  const bool few = mesh.faceCount() < 3 * charts;
  auto regions = flatRegions(mesh, few ? mesh.faceCount() : std::max(kManyPlanes, charts));
  if (regions && takesLong(regions->count, charts)) regions.reset();
  return regions;
}

}  // namespace

std::optional<CreaseRegions> flatRegions(const Mesh& mesh, std::size_t most) {
  CreaseRegions regions;
  regions.label.assign(mesh.faceCount(), kNone);
  std::vector<Index> queue;
  // Faces without area belong to what is beside them; alone, they come last.
  for (const bool flat : {true, false}) {
    for (Index f = 0; f < mesh.faceCount(); ++f) {
      if (regions.label[f] != kNone || (glm::length(faceVector(mesh, f)) > 0) != flat) continue;
      if (regions.count == most) return std::nullopt;
      growFlat(mesh, f, static_cast<Index>(regions.count++), regions.label, queue);
    }
  }
  return regions;
}

std::size_t featureCount(const Mesh& mesh) {
  const auto regions = flatRegions(mesh, kManyPlanes);
  if (!regions) return std::numeric_limits<std::size_t>::max();
  RegionGraph graph(mesh, regions->label, regions->count);
  while (graph.joinLone()) {
  }
  return graph.count();
}

std::vector<Index> quadPartners(const Mesh& mesh, const CreaseRegions& flat) {
  std::vector<std::pair<double, Index>> edges;
  const auto single = [&](Index f) {
    return mesh.triangleBegin(f + 1) - mesh.triangleBegin(f) == 1;
  };
  for (Index s = 0; s < mesh.opposite().size(); ++s) {
    const Index other = mesh.opposite()[s];
    if (other == kNone || other < s) continue;
    const Index f = mesh.faceOf(s / 3), g = mesh.faceOf(other / 3);
    if (f == g || flat.label[f] != flat.label[g] || !single(f) || !single(g)) continue;
    const double worst = squareness(mesh, s);
    if (worst < kLeastSquare) edges.emplace_back(worst, s);
  }
  // What differs by rounding alone goes by number.
  for (auto& [worst, side] : edges) worst = std::round(worst * 1e6);
  std::sort(edges.begin(), edges.end());
  std::vector<Index> partner(mesh.faceCount(), kNone);
  for (const auto& [worst, side] : edges) {
    const Index f = mesh.faceOf(side / 3), g = mesh.faceOf(mesh.opposite()[side] / 3);
    if (partner[f] != kNone || partner[g] != kNone) continue;
    partner[f] = g;
    partner[g] = f;
  }
  return partner;
}

std::optional<FlatParts> flatParts(const Mesh& mesh, std::size_t charts) {
  auto regions = fittingRegions(mesh, charts);
  if (!regions) return std::nullopt;
  std::vector<Index> partner = quadPartners(mesh, *regions);
  return FlatParts{std::move(*regions), std::move(partner)};
}

bool hasFlatParts(const Mesh& mesh, std::size_t charts) {
  return fittingRegions(mesh, charts).has_value();
}

}  // namespace chartflood
