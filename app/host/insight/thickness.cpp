#include "app/host/insight/thickness.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

#include <glm/geometric.hpp>

#include "core/base/cross.h"

namespace chartflood {

namespace {

/// Corners of the convex hull, counter-clockwise (Andrew's monotone chain).
std::vector<glm::dvec2> convexHull(std::span<const glm::dvec2> points) {
  std::vector<glm::dvec2> sorted(points.begin(), points.end());
  std::sort(sorted.begin(), sorted.end(), [](const glm::dvec2& a, const glm::dvec2& b) {
    return a.x != b.x ? a.x < b.x : a.y < b.y;
  });
  std::vector<glm::dvec2> hull;
  const auto add = [&](const glm::dvec2& p, std::size_t fixed) {
    while (hull.size() >= fixed + 2 &&
           cross(hull.back() - hull[hull.size() - 2], p - hull.back()) <= 0) {
      hull.pop_back();
    }
    hull.push_back(p);
  };
  for (const glm::dvec2& p : sorted) add(p, 0);
  const std::size_t lower = hull.size() - (hull.empty() ? 0 : 1);
  for (auto p = sorted.rbegin(); p != sorted.rend(); ++p) add(*p, lower);
  if (hull.size() > 1) hull.pop_back();
  return hull;
}

/// Least distance between two parallel lines around the points: one of them holds a side of the
/// hull.
double leastWidth(std::span<const glm::dvec2> points) {
  const std::vector<glm::dvec2> hull = convexHull(points);
  if (hull.size() < 3) return 0;
  double least = std::numeric_limits<double>::max();
  std::size_t far = 1;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const glm::dvec2 side = hull[(i + 1) % hull.size()] - hull[i];
    const auto height = [&](std::size_t k) { return cross(side, hull[k % hull.size()] - hull[i]); };
    // The farthest corner only moves on as the sides turn.
    for (std::size_t n = 0; n < hull.size() && height(far + 1) > height(far); ++n) ++far;
    least = std::min(least, height(far) / std::max(glm::length(side), 1e-300));
  }
  return least;
}

}  // namespace

double thickness(std::span<const glm::dvec2> points, double area, double perimeter) {
  const double hydraulic = perimeter > 0 ? 4 * area / perimeter : 0;
  return std::min(leastWidth(points), hydraulic);
}

}  // namespace chartflood
