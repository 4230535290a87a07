#include "core/param/unfold.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <queue>
#include <utility>

#include <glm/geometric.hpp>

#include "core/param/part_slits.h"
#include "core/param/stretch.h"

namespace chartflood {

namespace {

using Complex = std::complex<double>;

/// Way between two places of one vertex, over the shorter edge to it, that says it is none.
constexpr double kApart = 1e-2;
/// Squared L2 stretch above 1 that a chart without any may have from the rounding of its input.
constexpr double kUnstretched = 1e-4;

Complex unitOf(const glm::dvec2& v) {
  const double length = std::hypot(v.x, v.y);
  return length > 0 ? Complex(v.x / length, v.y / length) : Complex(1, 0);
}

glm::dvec2 turned(const Complex& by, const glm::dvec2& v) {
  return {by.real() * v.x - by.imag() * v.y, by.imag() * v.x + by.real() * v.y};
}

/// Turns triangles into the plane, across long edges first. Directions are handed on from triangle
/// to triangle as turns, not taken from places: across an edge a billion times shorter than its
/// neighbours they would be wrong in the seventh digit, and long triangles be off by more than
/// their width.
class Unfolder {
 public:
  explicit Unfolder(const ChartSurface& surface)
      : surface_(surface), uv_(surface.vertexCount(), glm::dvec2(0)),
        placed_(surface.vertexCount(), false), turn_(surface.triangleCount()),
        reached_(surface.triangleCount(), false) {}

  /// False when the chart does not close.
  bool run() {
    const FlatTriangle first = flatTriangle(surface_, 0);
    turn_[0] = 1;
    place(surface_.triangles[0][0], glm::dvec2(0));
    for (std::size_t i = 0; i < 2; ++i) {
      place(surface_.triangles[0][i + 1], uv_[surface_.triangles[0][i]] + first.edge[i]);
    }
    queueNeighbours(0, first);
    while (!hinges_.empty()) {
      const Index side = hinges_.top().side;
      hinges_.pop();
      if (!reached_[side / 3] && !visit(side)) return false;
    }
    return true;
  }

  std::vector<glm::dvec2> takePlaces() { return std::move(uv_); }

 private:
  struct Hinge {
    double length;
    Index side;  // of the triangle beyond
    bool operator<(const Hinge& other) const {
      return length != other.length ? length < other.length : side > other.side;
    }
  };

  void place(Index vertex, const glm::dvec2& at) {
    uv_[vertex] = at;
    placed_[vertex] = true;
  }

  void queueNeighbours(std::size_t triangle, const FlatTriangle& flat) {
    reached_[triangle] = true;
    for (std::size_t i = 0; i < 3; ++i) {
      const Index other = surface_.opposite[3 * triangle + i];
      if (other != kNone && !reached_[other / 3]) hinges_.push({glm::length(flat.edge[i]), other});
    }
  }

  /// \param side of the triangle, its edge already in the plane
  bool visit(Index side) {
    const std::size_t triangle = side / 3;
    const FlatTriangle flat = flatTriangle(surface_, triangle);
    const Index from = surface_.opposite[side];
    // The edge runs the other way there.
    const Complex turn = -turn_[from / 3] *
                         unitOf(flatTriangle(surface_, from / 3).edge[from % 3]) *
                         std::conj(unitOf(flat.edge[side % 3]));
    turn_[triangle] = turn / std::abs(turn);
    const Index a = surface_.sideStart(side), b = surface_.sideEnd(side);
    const Index tip = surface_.sideEnd(ChartSurface::nextSide(side));
    const glm::dvec2 fromB = flat.edge[(side % 3 + 1) % 3];
    const glm::dvec2 toA = flat.edge[(side % 3 + 2) % 3];
    const double lengthA = glm::length(toA), lengthB = glm::length(fromB);
    // From the nearer end: the direction's error grows with the way.
    const glm::dvec2 at = lengthB < lengthA ? uv_[b] + turned(turn_[triangle], fromB)
                                            : uv_[a] - turned(turn_[triangle], toA);
    if (!placed_[tip]) {
      place(tip, at);
    } else if (flat.hasShape() &&
               !(glm::distance(at, uv_[tip]) <= kApart * std::min(lengthA, lengthB))) {
      return false;
    }
    queueNeighbours(triangle, flat);
    return true;
  }

  const ChartSurface& surface_;
  std::vector<glm::dvec2> uv_;
  std::vector<bool> placed_;
  std::vector<Complex> turn_;  // from each triangle's own plane
  std::vector<bool> reached_;
  std::priority_queue<Hinge> hinges_;
};

}  // namespace

std::vector<glm::dvec2> unfold(const ChartSurface& surface) {
  Unfolder unfolder(surface);
  if (!unfolder.run()) return {};
  return unfolder.takePlaces();
}

std::vector<glm::dvec2> unfoldedMap(const ChartShape& shape) {
  std::vector<glm::dvec2> uv = unfold(shape.surface);
  if (uv.empty() || !scaleToUnitArea(shape.rest, uv) || !allPositive(shape.rest, uv)) return {};
  if (!partSlits(shape, uv)) return {};
  const auto triangles = triangleDistortion(shape.surface, uv);
  const double l2 = chartDistortion(shape.surface, triangles).l2;
  if (!(l2 * l2 <= 1 + kUnstretched)) return {};
  return uv;
}

}  // namespace chartflood
