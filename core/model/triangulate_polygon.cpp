#include "core/model/triangulate_polygon.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/model/clip_ears.h"

namespace chartflood {

namespace {

/// A fan's triangle may be turned by so much of the polygon's area before it counts: rounding.
constexpr double kTurned = 1e-12;

/// Corners seen along the normal, counter-clockwise.
std::vector<glm::dvec2> projected(std::span<const Index> loop, std::span<const Index> polygon,
                                  std::span<const glm::dvec3> positions, const glm::dvec3& normal) {
  const glm::dvec3 size = glm::abs(normal);
  const double length = glm::length(normal);
  glm::dvec3 u(1, 0, 0), v(0, 1, 0);
  if (length > 0) {
    const glm::dvec3 n = normal / length;
    // Across the axis that the normal has least of; exact where the plane is one of the axes'.
    const glm::dvec3 axis = size.x <= size.y && size.x <= size.z ? glm::dvec3(1, 0, 0)
                            : size.y <= size.z                   ? glm::dvec3(0, 1, 0)
                                                                 : glm::dvec3(0, 0, 1);
    u = glm::normalize(glm::cross(axis, n));
    v = glm::cross(n, u);
  }
  const glm::dvec3 origin = positions[polygon[loop[0]]];
  std::vector<glm::dvec2> points;
  points.reserve(loop.size());
  for (const Index corner : loop) {
    const glm::dvec3 p = positions[polygon[corner]] - origin;
    points.emplace_back(glm::dot(p, u), glm::dot(p, v));
  }
  return points;
}

}  // namespace

void PolygonTriangulator::addTriangle(Index a, Index b, Index c) {
  triangles_.push_back({loop_[a], loop_[b], loop_[c]});
}

/// Corners that repeat the one before them.
void PolygonTriangulator::dropRepeats(std::span<const Index> polygon) {
  loop_.clear();
  for (Index corner = 0; corner < polygon.size(); ++corner) {
    if (loop_.empty() || polygon[loop_.back()] != polygon[corner]) loop_.push_back(corner);
  }
  while (loop_.size() > 1 && polygon[loop_.back()] == polygon[loop_.front()]) loop_.pop_back();
}

/// Corners at which the outline runs back where it came from, unless nothing else is there.
void PolygonTriangulator::dropSpikes(std::span<const Index> polygon) {
  spikeless_.clear();
  for (const Index corner : loop_) {
    const std::size_t n = spikeless_.size();
    if (n >= 2 && polygon[spikeless_[n - 2]] == polygon[corner]) {
      spikeless_.pop_back();
    } else {
      spikeless_.push_back(corner);
    }
  }
  // The same around the first corner.
  std::size_t begin = 0;
  const auto vertex = [&](std::size_t i) { return polygon[spikeless_[i]]; };
  while (spikeless_.size() - begin >= 3) {
    const std::size_t last = spikeless_.size() - 1;
    if (vertex(last - 1) == vertex(begin)) {
      spikeless_.resize(last - 1);
      if (vertex(spikeless_.size() - 1) == vertex(begin)) spikeless_.pop_back();
    } else if (vertex(last) == vertex(begin + 1)) {
      ++begin;
      spikeless_.pop_back();
    } else {
      break;
    }
  }
  if (spikeless_.size() - begin < 3 || spikeless_.size() - begin == loop_.size()) return;
  loop_.assign(spikeless_.begin() + static_cast<std::ptrdiff_t>(begin), spikeless_.end());
}

/// \returns false when a triangle of the fan would face the other way or repeat a vertex.
bool PolygonTriangulator::fan(std::span<const Index> polygon,
                              std::span<const glm::dvec3> positions) {
  const auto vertex = [&](std::size_t i) { return polygon[loop_[i]]; };
  const glm::dvec3 origin = positions[vertex(0)];
  const auto twiceArea = [&](std::size_t i) {
    return glm::cross(positions[vertex(i)] - origin, positions[vertex(i + 1)] - origin);
  };
  normal_ = glm::dvec3(0);
  for (std::size_t i = 1; i + 1 < loop_.size(); ++i) normal_ += twiceArea(i);
  const double least = -kTurned * glm::dot(normal_, normal_);
  for (std::size_t i = 1; i + 1 < loop_.size(); ++i) {
    if (vertex(i) == vertex(0) || vertex(i + 1) == vertex(0)) return false;
    if (glm::dot(twiceArea(i), normal_) < least) return false;
  }
  for (Index i = 1; i + 1 < loop_.size(); ++i) {
    const Index t = i - 1;
    if (t > 0) diagonals_.emplace_back(3 * (t - 1) + 2, 3 * t);
    addTriangle(0, i, i + 1);
  }
  return true;
}

void PolygonTriangulator::run(std::span<const Index> polygon,
                              std::span<const glm::dvec3> positions) {
  triangles_.clear();
  diagonals_.clear();
  dropRepeats(polygon);
  if (loop_.size() > 3) dropSpikes(polygon);
  if (loop_.size() < 3) return;
  if (loop_.size() == 3) return addTriangle(0, 1, 2);
  if (fan(polygon, positions)) return;
  std::vector<Index> vertex;
  vertex.reserve(loop_.size());
  for (const Index corner : loop_) vertex.push_back(polygon[corner]);
  EarClipper::Result ears =
      EarClipper(projected(loop_, polygon, positions, normal_), std::move(vertex)).run();
  for (const auto& [a, b, c] : ears.triangles) addTriangle(a, b, c);
  diagonals_ = std::move(ears.diagonals);
}

}  // namespace chartflood
