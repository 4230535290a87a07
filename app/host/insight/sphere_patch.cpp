#include "app/host/insight/sphere_patch.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "app/host/insight/sphere_grid.h"

namespace chartflood {

namespace {

constexpr float kLongestSide = 0.18f;  // of a facet: about 10 degrees
constexpr double kFlat = 1e-9;         // steradians
constexpr std::size_t kMostPoints = 400;

glm::vec3 halfway(const glm::vec3& a, const glm::vec3& b) {
  const glm::vec3 sum = a + b;
  const float length = glm::length(sum);
  return length > 1e-6f ? sum / length : a;
}

float squaredLength(const glm::vec3& d) { return glm::dot(d, d); }

/// Halves a spherical triangle at its longest side until its sides are at most `side` long, and
/// calls `take(a, b, c)` for each part. Slivers fall into few parts.
template <typename Take>
void subdivide(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, float side, int depth,
               Take&& take) {
  const float ab = squaredLength(b - a), bc = squaredLength(c - b), ca = squaredLength(a - c);
  const float longest = std::max({ab, bc, ca});
  if (depth == 0 || longest <= side * side) return take(a, b, c);
  if (ab < longest) {
    return bc < longest ? subdivide(c, a, b, side, depth, take)
                        : subdivide(b, c, a, side, depth, take);
  }
  const glm::vec3 middle = halfway(a, b);
  subdivide(a, middle, c, side, depth - 1, take);
  subdivide(middle, b, c, side, depth - 1, take);
}

class PatchBuilder {
 public:
  PatchBuilder(const SurfaceDerived& surface, const Segmentation& segmentation, Index chart)
      : mesh_(*surface.mesh), gauss_(*surface.gaussArea), normal_(surface.normals.normal),
        label_(segmentation.label) {
    patch_.chart = chart;
  }

  SpherePatch run() {
    for (Index t = 0; t < mesh_.triangleCount(); ++t) {
      if (holds(t)) triangle(t);
    }
    for (std::size_t i = 0; i < gauss_.sharpEdges.size(); ++i) crease(i);
    for (std::size_t i = 0; i < gauss_.corners.size(); ++i) corner(i);
    keepSomeArcs();
    if (patch_.sampled) patch_.facets = grid_.facets();
    keepPoints();
    return std::move(patch_);
  }

 private:
  bool holds(Index triangle) const { return label_[mesh_.faceOf(triangle)] == patch_.chart; }

  void triangle(Index t) {
    patch_.faceArea += gauss_.triangle[t];
    if (gauss_.triangle[t] < kFlat) {
      flat_.push_back(normal_[3 * t]);
      return;
    }
    cover(normal_[3 * t], normal_[3 * t + 1], normal_[3 * t + 2]);
  }

  void crease(std::size_t i) {
    const Index side = gauss_.sharpEdges[i], other = mesh_.opposite()[side];
    const bool left = holds(side / 3), right = holds(other / 3);
    if (!left && !right) return;
    // nL and nR at both ends of the edge (paper section 3.2).
    const glm::vec3 l0 = normal_[side], l1 = normal_[Mesh::nextSide(side)];
    const glm::vec3 r1 = normal_[other], r0 = normal_[Mesh::nextSide(other)];
    patch_.arcs.push_back({l0, r0, left && right});
    patch_.arcs.push_back({l1, r1, left && right});
    if (!left || !right) return;
    patch_.edgeArea += gauss_.edge[i];
    if (gauss_.edge[i] < kFlat) return;
    cover(l1, l0, r0);
    cover(l1, r0, r1);
  }

  void corner(std::size_t i) {
    std::vector<glm::vec3> polygon;
    const Index first = mesh_.vertexSide()[gauss_.corners[i]];
    Index side = first;
    do {
      if (side == kNone || !holds(side / 3)) return;
      // A sector has the same normal at all its corners.
      if (polygon.empty() || polygon.back() != normal_[side]) polygon.push_back(normal_[side]);
      side = mesh_.turn(side);
    } while (side != first);
    if (polygon.size() > 1 && polygon.front() == polygon.back()) polygon.pop_back();
    patch_.cornerArea += gauss_.corner[i];
    if (polygon.size() < 3) return;
    glm::vec3 middle(0);
    for (const glm::vec3& n : polygon) middle += n;
    if (glm::length(middle) > 1e-3f) {
      middle = glm::normalize(middle);
      for (std::size_t k = 0; k < polygon.size(); ++k) {
        cover(middle, polygon[k], polygon[(k + 1) % polygon.size()]);
      }
    }
    if (patch_.corners.size() < kMostArcs) patch_.corners.push_back(std::move(polygon));
  }

  void cover(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    if (patch_.sampled) return sample(a, b, c);
    subdivide(a, b, c, kLongestSide, 10,
              [&](const glm::vec3& x, const glm::vec3& y, const glm::vec3& z) {
                patch_.facets.push_back({{x, y, z, z}, 3, 1.0f});
              });
    if (patch_.facets.size() <= kMostFacets) return;
    patch_.sampled = true;
    for (const SphereFacet& f : patch_.facets) sample(f.corner[0], f.corner[1], f.corner[2]);
    patch_.facets.clear();
  }

  void sample(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    subdivide(a, b, c, SphereGrid::kCellSide, 16,
              [&](const glm::vec3& x, const glm::vec3& y, const glm::vec3& z) {
                // So small a piece is flat.
                const float area = glm::length(glm::cross(y - x, z - x)) / 2;
                grid_.add(x + y + z, area);
                grid_.touch(x);
              });
  }

  /// Creases of one kind differ little from one to the next: some stand for all.
  void keepSomeArcs() {
    std::stable_partition(patch_.arcs.begin(), patch_.arcs.end(),
                          [](const SphereArc& arc) { return arc.inside; });
    if (patch_.arcs.size() <= kMostArcs) return;
    std::vector<SphereArc> some;
    for (std::size_t i = 0; i < kMostArcs; ++i) {
      some.push_back(patch_.arcs[i * patch_.arcs.size() / kMostArcs]);
    }
    patch_.arcs = std::move(some);
  }

  /// One point for all flat triangles of about the same direction.
  void keepPoints() {
    const auto rounded = [](const glm::vec3& n) {
      return std::array{std::lround(n.x * 100), std::lround(n.y * 100), std::lround(n.z * 100)};
    };
    std::sort(flat_.begin(), flat_.end(),
              [&](const glm::vec3& a, const glm::vec3& b) { return rounded(a) < rounded(b); });
    for (const glm::vec3& n : flat_) {
      if (patch_.points.size() >= kMostPoints) return;
      if (patch_.points.empty() || rounded(patch_.points.back()) != rounded(n))
        patch_.points.push_back(n);
    }
  }

  const Mesh& mesh_;
  const GaussArea& gauss_;
  const std::vector<glm::vec3>& normal_;
  const std::vector<Index>& label_;
  SpherePatch patch_;
  SphereGrid grid_;
  std::vector<glm::vec3> flat_;
};

}  // namespace

SpherePatch spherePatch(const SurfaceDerived& surface, const Segmentation& segmentation,
                        Index chart) {
  return PatchBuilder(surface, segmentation, chart).run();
}

std::vector<SphereDot> sphereDots(const SurfaceDerived& surface, std::size_t most) {
  const Mesh& mesh = *surface.mesh;
  const std::size_t count = std::min(most, mesh.triangleCount());
  std::vector<SphereDot> dots;
  dots.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const auto t = static_cast<Index>(i * mesh.triangleCount() / count);
    const glm::vec3* n = &surface.normals.normal[3 * std::size_t{t}];
    const glm::vec3 sum = n[0] + n[1] + n[2];
    const float length = glm::length(sum);
    dots.push_back({length > 1e-6f ? sum / length : n[0], mesh.faceOf(t)});
  }
  return dots;
}

}  // namespace chartflood
