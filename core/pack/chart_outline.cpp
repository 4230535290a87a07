#include "core/pack/chart_outline.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/base/cross.h"
#include "core/charts/chart_surface.h"

namespace chartflood {

namespace {

double doubleArea(const ChartSurface& surface, const std::vector<glm::dvec2>& uv, Index t) {
  const auto& [a, b, c] = surface.triangles[t];
  return cross(uv[b] - uv[a], uv[c] - uv[a]);
}

/// Andrew's monotone chain.
std::vector<glm::dvec2> convexHull(std::vector<glm::dvec2> points) {
  std::sort(points.begin(), points.end(), [](const glm::dvec2& a, const glm::dvec2& b) {
    return a.x != b.x ? a.x < b.x : a.y < b.y;
  });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  std::vector<glm::dvec2> hull;
  const auto extend = [&hull](const glm::dvec2& p, std::size_t keep) {
    while (hull.size() >= keep + 2 &&
           cross(hull.back() - hull[hull.size() - 2], p - hull.back()) <= 0) {
      hull.pop_back();
    }
    hull.push_back(p);
  };
  for (const glm::dvec2& p : points) extend(p, 0);
  const std::size_t lower = hull.size() - 1;
  for (std::size_t i = points.size() - 1; i-- > 0;) extend(points[i], lower);
  hull.pop_back();
  return hull;
}

EnclosingBox boxAt(const std::vector<glm::dvec2>& hull, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  glm::dvec2 low(INFINITY), high(-INFINITY);
  for (const glm::dvec2& p : hull) {
    const glm::dvec2 q(c * p.x - s * p.y, s * p.x + c * p.y);
    low = glm::min(low, q);
    high = glm::max(high, q);
  }
  return {angle, low, high - low};
}

EnclosingSquare squareAt(const std::vector<glm::dvec2>& hull, double angle) {
  const EnclosingBox box = boxAt(hull, angle);
  return {angle, std::max(box.size.x, box.size.y), box.low + 0.5 * box.size};
}

}  // namespace

ChartOutline outlineOf(const ChartSurface& surface, const std::vector<glm::dvec2>& uv) {
  ChartOutline outline;
  if (uv.empty() || surface.triangles.empty()) return outline;
  for (const glm::dvec2& p : uv) {
    if (!std::isfinite(p.x) || !std::isfinite(p.y)) return outline;
  }
  double signedArea = 0;
  for (Index t = 0; t < surface.triangleCount(); ++t) {
    const double area = doubleArea(surface, uv, t);
    signedArea += area / 2;
    outline.area += std::abs(area) / 2;
  }
  for (const std::vector<Index>& loop : boundaryLoops(surface)) {
    for (const Index side : loop) {
      outline.segments.push_back({uv[surface.sideStart(side)], uv[surface.sideEnd(side)]});
    }
  }
  // A triangle that faces the other way counts as -1 in the boundary's winding; its own border,
  // twice around the right way, makes that 1.
  const double most = signedArea < 0 ? -1 : 1;
  for (Index t = 0; t < surface.triangleCount(); ++t) {
    if (doubleArea(surface, uv, t) * most >= 0) continue;
    const auto& [a, b, c] = surface.triangles[t];
    for (int turn = 0; turn < 2; ++turn) {
      outline.segments.push_back({uv[b], uv[a]});
      outline.segments.push_back({uv[a], uv[c]});
      outline.segments.push_back({uv[c], uv[b]});
    }
  }
  std::vector<glm::dvec2> points;
  for (const Segment2& segment : outline.segments) points.push_back(segment[0]);
  if (points.empty()) points = uv;
  outline.hull = convexHull(std::move(points));
  return outline;
}

EnclosingSquare smallestSquare(const std::vector<glm::dvec2>& hull) {
  // The side is periodic in a quarter turn and, between the angles where the touching corners
  // change, the larger of two sinusoids: a fine scan finds the right valley.
  constexpr int kScan = 180;
  constexpr double kStep = std::numbers::pi / 2 / kScan;
  EnclosingSquare best = squareAt(hull, 0);
  for (int i = 1; i < kScan; ++i) {
    const EnclosingSquare at = squareAt(hull, i * kStep);
    if (at.side < best.side) best = at;
  }
  for (double step = kStep / 2; step > 1e-9; step /= 2) {
    for (const double angle : {best.angle - step, best.angle + step}) {
      const EnclosingSquare at = squareAt(hull, angle);
      if (at.side < best.side) best = at;
    }
  }
  return best;
}

EnclosingBox smallestBox(const std::vector<glm::dvec2>& hull) {
  // It has a side along the hull.
  EnclosingBox best = boxAt(hull, 0);
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const glm::dvec2 along = hull[(i + 1) % hull.size()] - hull[i];
    if (along == glm::dvec2(0)) continue;
    const EnclosingBox box = boxAt(hull, -std::atan2(along.y, along.x));
    if (box.size.x * box.size.y < best.size.x * best.size.y) best = box;
  }
  return best.size.x >= best.size.y ? best : boxAt(hull, best.angle + std::numbers::pi / 2);
}

glm::dvec2 circleCenter(const std::vector<glm::dvec2>& hull) {
  // Badoiu and Clarkson 2003: steps towards the farthest point that shrink as 1 / i.
  glm::dvec2 center(0);
  for (const glm::dvec2& p : hull) center += p / static_cast<double>(hull.size());
  for (int i = 1; i <= 100; ++i) {
    const auto far = std::max_element(hull.begin(), hull.end(), [&](const auto& a, const auto& b) {
      return glm::distance(a, center) < glm::distance(b, center);
    });
    center += (*far - center) / (i + 1.0);
  }
  return center;
}

}  // namespace chartflood
