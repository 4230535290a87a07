#include "core/segment/creases/revolution.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

namespace chartflood {

namespace {

constexpr double kRound = 0.03;            // how far a circle's points may lie off it, in radii
constexpr double kInCircles = 0.8;         // share of the length of sharp edges
constexpr double kPastAxis = 0.2;          // sine of the angle by which a normal may pass the axis
constexpr double kRevolved = 0.9;          // share of the surface
constexpr std::size_t kFewestCorners = 7;  // fewer are a polygon

struct CreaseCircle {
  glm::dvec3 center{0}, axis{0};
  double length = 0;
};

/// A closed chain of vertices as a circle; of no length when it is none.
CreaseCircle circleThrough(const Mesh& mesh, const std::vector<Index>& loop) {
  CreaseCircle circle;
  if (loop.size() < kFewestCorners) return circle;
  const auto p = mesh.positions();
  double length = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const glm::dvec3 &a = p[loop[i]], &b = p[loop[(i + 1) % loop.size()]];
    length += glm::length(b - a);
    circle.center += (a + b) / 2.0 * glm::length(b - a);
  }
  if (!(length > 0)) return circle;
  circle.center /= length;
  double radius = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const glm::dvec3 a = p[loop[i]] - circle.center;
    circle.axis += glm::cross(a, p[loop[(i + 1) % loop.size()]] - circle.center);
    radius += glm::length(a) / static_cast<double>(loop.size());
  }
  const double area = glm::length(circle.axis);
  if (!(area > 0)) return circle;
  circle.axis /= area;
  for (const Index v : loop) {
    const glm::dvec3 a = p[v] - circle.center;
    if (std::abs(glm::length(a) - radius) > kRound * radius) return circle;
    if (std::abs(glm::dot(a, circle.axis)) > kRound * radius) return circle;
  }
  circle.length = length;
  return circle;
}

/// Ends of sharp edges, both ways.
using SharpWays = std::multimap<Index, Index>;

/// The closed chain that begins with an edge, where no vertex on the way has a choice; its edges
/// are taken out. Empty when there is none.
std::vector<Index> takeLoop(SharpWays& ways, Index start) {
  std::vector<Index> loop;
  Index at = start, from = kNone;
  do {
    const auto [begin, end] = ways.equal_range(at);
    if (std::distance(begin, end) != 2) return {};
    const Index next = begin->second != from ? begin->second : std::next(begin)->second;
    loop.push_back(at);
    from = at;
    at = next;
  } while (at != start);
  for (const Index v : loop) ways.erase(v);
  return loop;
}

/// How far a face looks past the axis: the sine.
double pastAxis(const Mesh& mesh, Index triangle, const CreaseCircle& axis) {
  const auto p = mesh.positions();
  const auto& [a, b, c] = mesh.triangles()[triangle];
  const glm::dvec3 normal = glm::cross(p[b] - p[a], p[c] - p[a]);
  const glm::dvec3 round = glm::cross(axis.axis, (p[a] + p[b] + p[c]) / 3.0 - axis.center);
  const double lengths = glm::length(normal) * glm::length(round);
  return lengths > 0 ? std::abs(glm::dot(normal, round)) / lengths : 0;
}

std::vector<CreaseCircle> creaseCircles(const Mesh& mesh, const GaussArea& gauss, double& length) {
  SharpWays ways;
  for (const Index s : gauss.sharpEdges) {
    const Index a = mesh.sideStart(s), b = mesh.sideEnd(s);
    ways.emplace(a, b);
    ways.emplace(b, a);
    length += glm::length(mesh.positions()[a] - mesh.positions()[b]);
  }
  std::vector<CreaseCircle> circles;
  for (const Index s : gauss.sharpEdges) {
    const CreaseCircle circle = circleThrough(mesh, takeLoop(ways, mesh.sideStart(s)));
    if (circle.length > 0) circles.push_back(circle);
  }
  return circles;
}

}  // namespace

bool ringsBetweenCreases(const Mesh& mesh, const GaussArea& gauss) {
  double length = 0;
  const std::vector<CreaseCircle> circles = creaseCircles(mesh, gauss, length);
  if (circles.empty()) return false;
  const CreaseCircle axis = *std::max_element(
      circles.begin(), circles.end(),
      [](const CreaseCircle& a, const CreaseCircle& b) { return a.length < b.length; });
  const double size = axis.length / 6;  // about the radius
  double around = 0;
  for (const CreaseCircle& circle : circles) {
    const glm::dvec3 off = glm::cross(circle.center - axis.center, axis.axis);
    const bool same = std::abs(glm::dot(circle.axis, axis.axis)) > 1 - kRound;
    if (same && glm::length(off) <= kRound * size) around += circle.length;
  }
  if (around < kInCircles * length) return false;
  double revolved = 0;
  for (Index t = 0; t < mesh.triangleCount(); ++t) {
    if (pastAxis(mesh, t, axis) <= kPastAxis) revolved += mesh.triangleArea()[t];
  }
  return revolved >= kRevolved * mesh.surfaceArea();
}

}  // namespace chartflood
