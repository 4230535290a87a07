/// Samples that are turned around an axis: sphere, torus, cylinder, tube, cone.

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/samples/sample_shapes.h"
#include "core/samples/sample_surface.h"

namespace chartflood {

namespace {

using Triangle = std::array<Index, 3>;

struct Solid {
  std::vector<glm::dvec3> vertices;
  std::vector<Triangle> faces;
};

Solid icosahedron() {
  const double g = (1 + std::sqrt(5.0)) / 2;
  return {{{-1, g, 0},
           {1, g, 0},
           {-1, -g, 0},
           {1, -g, 0},
           {0, -1, g},
           {0, 1, g},
           {0, -1, -g},
           {0, 1, -g},
           {g, 0, -1},
           {g, 0, 1},
           {-g, 0, -1},
           {-g, 0, 1}},
          {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
           {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
           {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};
}

Solid octahedron() {
  return {{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
          {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
}

/// Cuts every face into n * n triangles and moves the vertices onto the unit sphere. Corners and
/// edges are shared by the key of the solid's vertices and their weights.
class Geodesic {
 public:
  Geodesic(const Solid& solid, int n) : solid_(solid), n_(n) {}

  InputMesh make() {
    for (const Triangle& face : solid_.faces) {
      for (int row = 0; row < n_; ++row) {
        for (int i = 0; i < n_ - row; ++i) {
          emit(face, {row, i}, {row, i + 1}, {row + 1, i});
          if (i + row + 1 < n_) emit(face, {row, i + 1}, {row + 1, i + 1}, {row + 1, i});
        }
      }
    }
    return std::move(mesh_);
  }

 private:
  struct Place {
    int row, i;
  };
  using Key = std::array<std::pair<Index, int>, 3>;

  void emit(const Triangle& face, Place a, Place b, Place c) {
    for (const Place p : {a, b, c}) mesh_.corners.push_back(vertex(face, p));
  }
  Index vertex(const Triangle& face, Place p) {
    const std::array<int, 3> weight = {n_ - p.row - p.i, p.i, p.row};
    Key key;
    glm::dvec3 position(0);
    for (std::size_t k = 0; k < 3; ++k) {
      key[k] = {weight[k] == 0 ? kNone : face[k], weight[k]};
      position += static_cast<double>(weight[k]) * glm::normalize(solid_.vertices[face[k]]);
    }
    std::sort(key.begin(), key.end());
    const auto [found, isNew] = numbers_.emplace(key, static_cast<Index>(mesh_.positions.size()));
    if (isNew) mesh_.positions.push_back(glm::normalize(position));
    return found->second;
  }

  const Solid& solid_;
  int n_;
  InputMesh mesh_;
  std::map<Key, Index> numbers_;
};

/// Rows of vertices straight up from a ring to the same ring at another height, or to a tip when
/// `radius` is 0. All edges along the rulings lie in the surface, so that its facets bend around
/// these only, as the surface itself does: staggered rows would crumple it.
Row ruleUpTo(SampleSurface& surface, const Row& ring, double radius, double height) {
  const glm::dvec3 first = surface.at(ring.front());
  const double below = std::hypot(first.x, first.y);
  const auto above = [&](Index vertex) {
    const glm::dvec3& p = surface.at(vertex);
    return glm::dvec3(p.x * radius / below, p.y * radius / below, height);
  };
  const std::size_t rows = surface.edgesFor(std::hypot(height - first.z, radius - below));
  Row lower = ring;
  for (std::size_t i = 1; i <= rows; ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(rows);
    Row upper;
    const bool tip = i == rows && radius == 0;
    for (std::size_t k = 0; k < (tip ? 1 : ring.size()); ++k) {
      upper.push_back(surface.add(glm::mix(surface.at(ring[k]), above(ring[k]), t)));
    }
    surface.zipRings(lower, upper);
    lower = std::move(upper);
  }
  return lower;
}

}  // namespace

InputMesh makeSphere(double edge) {
  // Triangles of this edge length that cover the sphere.
  const double wanted = 4 * std::numbers::pi / (edge * edge * std::sqrt(3.0) / 4);
  const auto cuts = [&](double faces) {
    return std::max(1, static_cast<int>(std::lround(std::sqrt(wanted / faces))));
  };
  const auto miss = [&](double faces) {
    return std::abs(std::log(faces * cuts(faces) * cuts(faces) / wanted));
  };
  // The icosahedron's triangles are more even; the octahedron only fills large gaps.
  if (miss(20) < 0.1 || miss(20) <= miss(8)) return Geodesic(icosahedron(), cuts(20)).make();
  return Geodesic(octahedron(), cuts(8)).make();
}

InputMesh makeTorus(double edge) {
  constexpr double kLarge = 1, kSmall = 0.4;
  SampleSurface surface(edge);
  // An even number, so that rows stay staggered all around.
  const std::size_t rows =
      2 * std::max<std::size_t>(surface.rowsFor(2 * std::numbers::pi * kSmall) / 2, 2);
  const auto ring = [&](std::size_t i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(rows);
    return surface.ring(kLarge + kSmall * std::cos(angle), kSmall * std::sin(angle), i % 2 == 1);
  };
  const Row first = ring(0);
  Row last = first;
  for (std::size_t i = 1; i < rows; ++i) {
    Row next = ring(i);
    surface.zipRings(last, next);
    last = std::move(next);
  }
  surface.zipRings(last, first);
  return surface.take();
}

InputMesh makeCylinder(double edge) {
  SampleSurface surface(edge);
  Row row = surface.ring(0, -1, false);
  row = surface.revolve(row, straight({0, -1}, {0.6, -1}));
  row = ruleUpTo(surface, row, 0.6, 1);
  surface.revolve(row, straight({0.6, 1}, {0, 1}));
  return surface.take();
}

InputMesh makeTube(double edge) {
  SampleSurface surface(edge);
  ruleUpTo(surface, surface.ring(0.6, -1, false), 0.6, 1);
  return surface.take();
}

InputMesh makeCone(double edge) {
  SampleSurface surface(edge);
  ruleUpTo(surface, surface.ring(1, 0, false), 0, 2);
  return surface.take();
}

}  // namespace chartflood
