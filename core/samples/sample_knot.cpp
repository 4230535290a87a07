/// The knot: a square cross-section, slightly hollowed, carried along a trefoil while it turns.

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <glm/geometric.hpp>

#include "core/samples/sample_shapes.h"
#include "core/samples/sample_surface.h"

namespace chartflood {

namespace {

constexpr double kHalfWidth = 0.36;       ///< of the cross-section
constexpr std::size_t kQuarterTurns = 3;  ///< of the section along the knot

glm::dvec3 trefoil(double t) {
  const double a = 2 * std::numbers::pi * t;
  return {std::sin(a) + 2 * std::sin(2 * a), std::cos(a) - 2 * std::cos(2 * a),
          -1.3 * std::sin(3 * a)};
}

/// Where the section lies: its middle and two directions across the knot.
struct Frame {
  glm::dvec3 middle, right, up;
};

/// Frames that turn as little as possible along the curve, with the rest of the turn spread evenly
/// so that the ends meet after a whole number of quarter turns.
std::vector<Frame> framesAlong(std::size_t count) {
  std::vector<Frame> frames;
  glm::dvec3 right(0, 0, 1);
  const auto at = [&](std::size_t i) {
    return trefoil(static_cast<double>(i) / static_cast<double>(count));
  };
  for (std::size_t i = 0; i <= count; ++i) {
    const glm::dvec3 along = glm::normalize(at(i + 1) - at(i + count - 1));
    right = glm::normalize(right - glm::dot(right, along) * along);
    frames.push_back({at(i), right, glm::cross(along, right)});
  }
  const Frame& first = frames.front();
  const double missing = std::atan2(glm::dot(frames.back().right, first.up),
                                    glm::dot(frames.back().right, first.right));
  const double turn = static_cast<double>(kQuarterTurns) * std::numbers::pi / 2 - missing;
  for (std::size_t i = 0; i <= count; ++i) {
    const double angle = turn * static_cast<double>(i) / static_cast<double>(count);
    const glm::dvec3 r = frames[i].right, u = frames[i].up;
    frames[i].right = std::cos(angle) * r + std::sin(angle) * u;
    frames[i].up = std::cos(angle) * u - std::sin(angle) * r;
  }
  return frames;
}

}  // namespace

InputMesh makeKnot(double edge) {
  SampleSurface s(edge);
  double length = 0;
  for (int i = 0; i < 1000; ++i)
    length += glm::distance(trefoil(i * 1e-3), trefoil((i + 1) * 1e-3));
  const std::size_t rows = 2 * std::max<std::size_t>(s.rowsFor(length) / 2, 12);
  const std::size_t across = s.edgesFor(2 * kHalfWidth);
  const std::vector<Frame> frames = framesAlong(rows);
  constexpr std::array<glm::dvec2, 4> kCorners = {{{1, -1}, {1, 1}, {-1, 1}, {-1, -1}}};

  // Four rows around the section, one a side, sharing their end vertices.
  const auto section = [&](std::size_t i) {
    const Frame& f = frames[i];
    const auto point = [&](glm::dvec2 p) {
      return f.middle + kHalfWidth * (p.x * f.right + p.y * f.up);
    };
    std::array<Index, 4> corner;
    for (std::size_t k = 0; k < 4; ++k) corner[k] = s.add(point(kCorners[k]));
    std::array<Row, 4> sides;
    for (std::size_t k = 0; k < 4; ++k) {
      const glm::dvec2 a = kCorners[k], b = kCorners[(k + 1) % 4];
      sides[k] = s.between(corner[k], corner[(k + 1) % 4], across, i % 2 == 1, [&](double t) {
        const double hollow = 1 - 0.45 * 4 * t * (1 - t) * 0.5;
        const glm::dvec2 middle = (a + b) * 0.5;
        return point(a + t * (b - a) - middle * (1 - hollow));
      });
    }
    return sides;
  };
  const std::array<Row, 4> first = section(0);
  std::array<Row, 4> last = first;
  for (std::size_t i = 1; i <= rows; ++i) {
    // After the quarter turns, each side meets the first section's next ones.
    std::array<Row, 4> next;
    if (i < rows) {
      next = section(i);
    } else {
      for (std::size_t k = 0; k < 4; ++k) next[k] = first[(k + kQuarterTurns) % 4];
    }
    for (std::size_t k = 0; k < 4; ++k) s.zip(last[k], next[k]);
    last = std::move(next);
  }
  return s.take();
}

}  // namespace chartflood
