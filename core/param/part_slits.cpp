#include "core/param/part_slits.h"

#include <algorithm>
#include <limits>

#include <glm/geometric.hpp>

#include "core/param/border_crossings.h"

namespace chartflood {

namespace {

constexpr double kTouch = 1e-3;     // distance, over the shorter boundary edge, that counts as none
constexpr double kPull = 1e-2;      // way of a vertex, over its shortest edge, in the first pass
constexpr int kPasses = 5;          // each pulls twice as far as the one before
constexpr double kLeastLeft = 0.5;  // share of its area that a triangle keeps

/// The triangles around each boundary vertex.
class BoundaryFans {
 public:
  explicit BoundaryFans(const ChartShape& shape)
      : shape_(shape), triangles_(shape.rest.triangles), fans_(shape.rest.vertexCount()) {
    for (Index t = 0; t < triangles_.size(); ++t) {
      for (const Index v : triangles_[t]) {
        if (shape.onBoundary[v]) fans_[v].push_back(t);
      }
    }
  }

  /// Moves a vertex into its own fan by `share` of its shortest edge, less when triangles would
  /// get too thin.
  void pull(Index vertex, double share, std::vector<glm::dvec2>& uv) const {
    const glm::dvec2 from = uv[vertex];
    glm::dvec2 inwards(0);
    double shortest = std::numeric_limits<double>::infinity();
    for (const Index t : fans_[vertex]) {
      for (const Index other : triangles_[t]) {
        if (other == vertex) continue;
        inwards += uv[other] - from;
        shortest = std::min(shortest, glm::distance(uv[other], from));
      }
    }
    const double length = glm::length(inwards);
    if (!(length > 0)) return;
    glm::dvec2 way = share * shortest / length * inwards;
    for (int halving = 0; halving < 8; ++halving, way *= 0.5) {
      uv[vertex] = from;
      if (keepsAreas(vertex, way, uv)) {
        uv[vertex] = from + way;
        return;
      }
    }
  }

 private:
  bool keepsAreas(Index vertex, const glm::dvec2& way, const std::vector<glm::dvec2>& uv) const {
    const auto place = [&](Index v) { return v == vertex ? uv[v] + way : uv[v]; };
    return std::all_of(fans_[vertex].begin(), fans_[vertex].end(), [&](Index t) {
      const auto& v = triangles_[t];
      return signedArea(place(v[0]), place(v[1]), place(v[2])) >
             kLeastLeft * signedArea(uv[v[0]], uv[v[1]], uv[v[2]]);
    });
  }

  const ChartShape& shape_;
  std::span<const std::array<Index, 3>> triangles_;
  std::vector<std::vector<Index>> fans_;
};

}  // namespace

bool partSlits(const ChartShape& shape, std::vector<glm::dvec2>& uv) {
  std::vector<bool> touching;
  if (!findTouches(shape.boundary, uv, kTouch, touching)) return true;
  const BoundaryFans fans(shape);
  double share = kPull;
  for (int pass = 0; pass < kPasses; ++pass, share *= 2) {
    for (std::size_t i = 0; i < touching.size(); ++i) {
      if (touching[i]) fans.pull(shape.boundary[i], share, uv);
    }
    if (!findTouches(shape.boundary, uv, kTouch, touching)) return true;
  }
  return false;
}

}  // namespace chartflood
