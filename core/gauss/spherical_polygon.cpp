#include "core/gauss/spherical_polygon.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <glm/geometric.hpp>

namespace chartflood {

namespace {

constexpr double kFullSphere = 4 * std::numbers::pi;

/// Where the arcs a-b and c-d cross in their interiors; false when they do not.
bool properCrossing(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c,
                    const glm::dvec3& d, glm::dvec3& crossing) {
  const glm::dvec3 ab = glm::cross(a, b), cd = glm::cross(c, d);
  const double sa = glm::dot(a, cd), sb = glm::dot(b, cd);
  const double sc = glm::dot(c, ab), sd = glm::dot(d, ab);
  const bool front = sa > 0 && sb < 0 && sc < 0 && sd > 0;
  const bool back = sa < 0 && sb > 0 && sc > 0 && sd < 0;
  if (!front && !back) return false;
  const glm::dvec3 along = glm::cross(ab, cd);
  const double length = glm::length(along);
  if (!(length > 0)) return false;
  crossing = along * ((front ? 1.0 : -1.0) / length);
  return true;
}

double simpleLoopArea(std::span<const glm::dvec3> corners) {
  const double area = std::fmod(std::abs(signedPolygonArea(corners)), kFullSphere);
  return std::min(area, kFullSphere - area);
}

}  // namespace

double signedTriangleArea(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  const double volume = glm::dot(a, glm::cross(b, c));
  const double base = 1 + glm::dot(a, b) + glm::dot(b, c) + glm::dot(c, a);
  // Nearly all triangles of a mesh are small: their arc tangent by its series, exact to 1e-17.
  if (base > 0 && std::abs(volume) < 0.05 * base) {
    const double x = volume / base, y = x * x;
    return 2 * x *
           (1 - y * (1.0 / 3 -
                     y * (1.0 / 5 - y * (1.0 / 7 - y * (1.0 / 9 - y * (1.0 / 11 - y / 13))))));
  }
  return 2 * std::atan2(volume, base);
}

double signedPolygonArea(std::span<const glm::dvec3> corners) {
  double area = 0;
  for (std::size_t i = 2; i < corners.size(); ++i) {
    area += signedTriangleArea(corners[0], corners[i - 1], corners[i]);
  }
  return area;
}

double absolutePolygonArea(std::span<const glm::dvec3> corners) {
  if (corners.size() < 3) return 0;
  if (corners.size() == 3) return simpleLoopArea(corners);
  // The path so far never crosses itself. An arc that would cross it closes a simple loop, which
  // is cut off and added; the arc goes on from the crossing.
  double area = 0;
  std::vector<glm::dvec3> path{corners[0]};
  for (std::size_t i = 1; i <= corners.size(); ++i) {
    const glm::dvec3 end = corners[i % corners.size()];
    while (true) {
      const glm::dvec3 begin = path.back();
      std::size_t cut = path.size();
      double nearest = 2;
      glm::dvec3 crossing(0), point(0);
      for (std::size_t j = 0; j + 2 < path.size(); ++j) {
        if (!properCrossing(begin, end, path[j], path[j + 1], point)) continue;
        const double distance = 1 - glm::dot(begin, point);
        if (distance < nearest) {
          nearest = distance;
          cut = j;
          crossing = point;
        }
      }
      if (cut == path.size()) break;
      std::vector<glm::dvec3> loop(path.begin() + static_cast<std::ptrdiff_t>(cut) + 1, path.end());
      loop.push_back(crossing);
      area += simpleLoopArea(loop);
      path.resize(cut + 1);
      path.push_back(crossing);
    }
    path.push_back(end);
  }
  path.pop_back();  // the last corner is the first again
  return std::min(area + simpleLoopArea(path), kFullSphere);
}

}  // namespace chartflood
