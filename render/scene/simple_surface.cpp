#include "render/scene/simple_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <unordered_map>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "render/scene/packed_normal.h"

namespace chartflood {

namespace {

constexpr double kSmallestCell = 1e-6;  // 21 bits count them along the box, whose diagonal is 1
constexpr float kSameSide = 0.25f;      // cosine between normals up to which corners are one

glm::dvec3 placeOf(const SurfaceVertices::Vertex& vertex) {
  return {vertex.place[0], vertex.place[1], vertex.place[2]};
}

/// The cells that vertices lie in, numbered as they are met.
class Cells {
 public:
  Cells(const SurfaceVertices& list, double size) : of_(list.vertices.size()) {
    glm::dvec3 low(std::numeric_limits<double>::max());
    for (const auto& vertex : list.vertices) low = glm::min(low, placeOf(vertex));
    std::unordered_map<std::uint64_t, Index> known;
    for (std::size_t v = 0; v < of_.size(); ++v) {
      const glm::dvec3 at = (placeOf(list.vertices[v]) - low) / size;
      const std::uint64_t key = static_cast<std::uint64_t>(at.x) |
                                static_cast<std::uint64_t>(at.y) << 21 |
                                static_cast<std::uint64_t>(at.z) << 42;
      of_[v] = known.emplace(key, static_cast<Index>(known.size())).first->second;
    }
    count_ = known.size();
  }
  Index operator[](std::size_t vertex) const { return of_[vertex]; }
  std::size_t count() const { return count_; }

 private:
  std::vector<Index> of_;
  std::size_t count_ = 0;
};

/// Corners that become one vertex: sums over them.
struct Group {
  Index cell = kNone, island = kNone;
  Index older = kNone;  ///< the group of the cell that was made before
  glm::vec3 first{0};   ///< normal
  glm::dvec3 normal{0}, texture{0};
  double count = 0;
};

struct Cell {
  Index newest = kNone;  ///< group
  glm::dvec3 place{0};   ///< sum over its corners
  double count = 0;
  bool kept = false;  ///< a triangle stays there
};

class Clustering {
 public:
  Clustering(const SurfaceVertices& list, const UvLayout* layout, double size)
      : list_(list), layout_(layout), cellOf_(list, size), cells_(cellOf_.count()) {}

  /// Adds the corner to its group, which it returns.
  Index add(std::size_t corner) {
    const Index vertex = list_.indices[corner];
    Cell& cell = cells_[cellOf_[vertex]];
    const glm::vec3 normal =
        list_.hasNormals ? unpackNormal(list_.vertices[vertex].normal) : glm::vec3(0);
    const Index island = layout_ ? layout_->island[corner / 3] : kNone;
    Index at = cell.newest;
    while (at != kNone && !(groups_[at].island == island && sameSide(groups_[at].first, normal))) {
      at = groups_[at].older;
    }
    if (at == kNone) {
      at = static_cast<Index>(groups_.size());
      groups_.push_back({cellOf_[vertex], island, cell.newest, normal, {}, {}, 0});
      cell.newest = at;
    }
    Group& group = groups_[at];
    group.normal += normal;
    if (layout_) group.texture += layout_->corners[corner];
    group.count += 1;
    cell.place += placeOf(list_.vertices[vertex]);
    cell.count += 1;
    return at;
  }
  Index cellOf(Index group) const { return groups_[group].cell; }
  void keep(Index cell) { cells_[cell].kept = true; }
  /// True when nothing would be left where the corner is.
  bool vanishes(std::size_t corner) const { return !cells_[cellOf_[list_.indices[corner]]].kept; }

  /// For the corners of a triangle that stays: groups of their cells and islands whose normals fit
  /// the triangle as it lies now (those of single corners, such as of small folds, seldom do), in
  /// an order that turns its front to where nearly all normals around point.
  std::array<Index, 3> fitting(std::array<Index, 3> groups) const {
    if (!list_.hasNormals) return groups;
    std::array<glm::dvec3, 3> place;
    glm::dvec3 most{0};  // of the normals around
    double all = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const Cell& cell = cells_[groups_[groups[i]].cell];
      place[i] = cell.place / cell.count;
      for (Index g = cell.newest; g != kNone; g = groups_[g].older) most += groups_[g].normal;
      all += cell.count;
    }
    glm::dvec3 plane = glm::cross(place[1] - place[0], place[2] - place[0]);
    const double length = glm::length(plane);
    if (!(length > 0)) return groups;
    plane /= length;
    if (glm::length(most) > 0.2 * all && glm::dot(plane, most) < 0) {
      plane = -plane;
      std::swap(groups[1], groups[2]);
    }
    std::array<Index, 3> best = groups;
    for (std::size_t i = 0; i < 3; ++i) {
      const Group& own = groups_[groups[i]];
      double fit = -2;
      for (Index g = cells_[own.cell].newest; g != kNone; g = groups_[g].older) {
        const Group& group = groups_[g];
        if (group.island != own.island) continue;
        const double size = glm::length(group.normal);
        const double cosine = size > 0 ? glm::dot(group.normal, plane) / size : -1.0;
        if (cosine <= fit) continue;
        fit = cosine;
        best[i] = g;
      }
    }
    return best;
  }

  /// One vertex a group.
  void fill(SurfaceVertices& surface) const {
    surface.hasNormals = list_.hasNormals;
    surface.vertices.reserve(groups_.size());
    for (const Group& group : groups_) {
      const Cell& cell = cells_[group.cell];
      const glm::vec3 place(cell.place / cell.count);
      const double length = glm::length(group.normal);
      const glm::vec3 normal = length > 0 ? glm::vec3(group.normal / length) : group.first;
      surface.vertices.push_back({{place.x, place.y, place.z}, packNormal(normal)});
      if (layout_) surface.texture.push_back(glm::vec3(group.texture / group.count));
    }
  }
  /// The corner as it is in the mesh, as a vertex of its own.
  void append(std::size_t corner, SurfaceVertices& surface) const {
    surface.indices.push_back(static_cast<Index>(surface.vertices.size()));
    surface.vertices.push_back(list_.vertices[list_.indices[corner]]);
    if (layout_) surface.texture.push_back(layout_->corners[corner]);
  }

 private:
  bool sameSide(const glm::vec3& a, const glm::vec3& b) const {
    return !list_.hasNormals || glm::dot(a, b) > kSameSide;
  }

  const SurfaceVertices& list_;
  const UvLayout* layout_;
  Cells cellOf_;
  std::vector<Cell> cells_;
  std::vector<Group> groups_;
};

}  // namespace

std::shared_ptr<const SimpleSurface> simpleSurface(const Mesh& mesh,
                                                   const SurfaceVertices& vertices,
                                                   const UvLayout* layout, std::size_t wanted) {
  auto simple = std::make_shared<SimpleSurface>();
  if (!(mesh.surfaceArea() > 0)) return simple;
  // A plane of area A meets 1.5 A / size^2 cells on average over its directions, and there are two
  // triangles for each vertex.
  const double triangles = static_cast<double>(std::max<std::size_t>(wanted, 1));
  const double size = std::max(kSmallestCell, std::sqrt(3 * mesh.surfaceArea() / triangles));
  simple->detail = size;
  Clustering clusters(vertices, layout, size);
  std::vector<Index>& indices = simple->surface.indices;
  for (std::size_t t = 0; t < mesh.triangleCount(); ++t) {
    std::array<Index, 3> groups{}, cells{};
    for (std::size_t i = 0; i < 3; ++i) {
      groups[i] = clusters.add(3 * t + i);
      cells[i] = clusters.cellOf(groups[i]);
    }
    if (cells[0] == cells[1] || cells[1] == cells[2] || cells[2] == cells[0]) continue;
    for (const Index cell : cells) clusters.keep(cell);
    indices.insert(indices.end(), groups.begin(), groups.end());
    simple->triangles.push_back(static_cast<Index>(t));
  }
  for (std::size_t c = 0; c < indices.size(); c += 3) {
    const auto fitting = clusters.fitting({indices[c], indices[c + 1], indices[c + 2]});
    std::copy(fitting.begin(), fitting.end(), indices.begin() + static_cast<std::ptrdiff_t>(c));
  }
  clusters.fill(simple->surface);
  // Wires and crumbs thinner than a cell stay as they are.
  for (std::size_t t = 0; t < mesh.triangleCount(); ++t) {
    const auto vanishes = [&](std::size_t i) { return clusters.vanishes(3 * t + i); };
    if (!vanishes(0) && !vanishes(1) && !vanishes(2)) continue;
    for (std::size_t i = 0; i < 3; ++i) clusters.append(3 * t + i, simple->surface);
    simple->triangles.push_back(static_cast<Index>(t));
  }
  // Little is won where most is thin.
  if (2 * simple->triangles.size() > mesh.triangleCount()) return std::make_shared<SimpleSurface>();
  return simple;
}

}  // namespace chartflood
