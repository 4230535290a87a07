#include "core/param/part_slits.h"

#include <algorithm>
#include <limits>
#include <optional>

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

  /// Least height of the triangles at each boundary vertex: what lies farther away is no slit.
  std::vector<double> room(const std::vector<glm::dvec2>& uv) const {
    std::vector<double> room;
    for (const Index vertex : shape_.boundary) room.push_back(roomOf(vertex, uv));
    return room;
  }

  /// Moves a vertex into its own fan by `share` of its shortest edge, less when triangles would
  /// get too thin.
  void pull(Index vertex, double share, std::vector<glm::dvec2>& uv) const {
    double shortest = std::numeric_limits<double>::infinity();
    for (const Index t : fans_[vertex]) {
      for (const Index other : triangles_[t]) {
        if (other != vertex) shortest = std::min(shortest, glm::distance(uv[other], uv[vertex]));
      }
    }
    move(vertex, share * shortest, inwards(vertex, uv), uv);
  }

  /// Moves a vertex by `share` of its room away from the fans of the others that stand for the same
  /// vertex of the mesh and lie on it: the fans of thin triangles may well point the same way.
  void pullFrom(std::span<const Index> copies, Index vertex, double share,
                std::vector<glm::dvec2>& uv) const {
    const double room = roomOf(vertex, uv);
    const auto unit = [&](Index v) { return glm::normalize(inwards(v, uv)); };
    glm::dvec2 way = unit(vertex);
    for (const Index other : copies) {
      if (other != vertex && glm::distance(uv[other], uv[vertex]) < room) way -= unit(other);
    }
    move(vertex, share * room, way, uv);
  }

 private:
  /// Sum of the edges from the vertex, those inside its fan twice.
  glm::dvec2 inwards(Index vertex, const std::vector<glm::dvec2>& uv) const {
    glm::dvec2 sum(0);
    for (const Index t : fans_[vertex]) {
      for (const Index other : triangles_[t]) {
        if (other != vertex) sum += uv[other] - uv[vertex];
      }
    }
    return sum;
  }

  void move(Index vertex, double by, const glm::dvec2& towards, std::vector<glm::dvec2>& uv) const {
    const glm::dvec2 from = uv[vertex];
    const double length = glm::length(towards);
    if (!(length > 0)) return;
    glm::dvec2 way = by / length * towards;
    for (int halving = 0; halving < 8; ++halving, way *= 0.5) {
      uv[vertex] = from;
      if (keepsAreas(vertex, way, uv)) {
        uv[vertex] = from + way;
        return;
      }
    }
  }

  double roomOf(Index vertex, const std::vector<glm::dvec2>& uv) const {
    double least = std::numeric_limits<double>::infinity();
    for (const Index t : fans_[vertex]) {
      const glm::dvec2 &a = uv[triangles_[t][0]], &b = uv[triangles_[t][1]],
                       &c = uv[triangles_[t][2]];
      const double longest =
          std::max({glm::distance(a, b), glm::distance(b, c), glm::distance(c, a)});
      if (longest > 0) least = std::min(least, 2 * signedArea(a, b, c) / longest);
    }
    return least;
  }

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

/// The vertices of the boundary that stand for each vertex of the mesh, those of one together.
class Copies {
 public:
  explicit Copies(const ChartShape& shape) : mesh_(shape.surface.meshVertex) {
    vertices_ = shape.boundary;
    std::sort(vertices_.begin(), vertices_.end(),
              [&](Index a, Index b) { return mesh_[a] != mesh_[b] ? mesh_[a] < mesh_[b] : a < b; });
  }
  std::span<const Index> of(Index vertex) const {
    const auto range = std::equal_range(vertices_.begin(), vertices_.end(), vertex,
                                        [&](Index a, Index b) { return mesh_[a] < mesh_[b]; });
    return {range.first, range.second};
  }

 private:
  std::span<const Index> mesh_;
  std::vector<Index> vertices_;
};

}  // namespace

bool partSlits(const ChartShape& shape, std::vector<glm::dvec2>& uv) {
  const bool thin = shape.rest.thinness.any();
  std::vector<bool> touching;
  std::optional<BoundaryFans> fans;
  if (thin) fans.emplace(shape);
  const auto touches = [&] {
    const std::vector<double> room = thin ? fans->room(uv) : std::vector<double>();
    return findTouches(shape.boundary, uv, kTouch, room, touching);
  };
  if (!touches()) return true;
  if (!fans) fans.emplace(shape);
  std::optional<Copies> copies;
  if (thin) copies.emplace(shape);
  double share = kPull;
  for (int pass = 0; pass < kPasses; ++pass, share *= 2) {
    for (std::size_t i = 0; i < touching.size(); ++i) {
      if (!touching[i]) continue;
      const Index vertex = shape.boundary[i];
      if (thin) {
        fans->pullFrom(copies->of(vertex), vertex, share, uv);
      } else {
        fans->pull(vertex, share, uv);
      }
    }
    if (!touches()) return true;
  }
  return false;
}

}  // namespace chartflood
