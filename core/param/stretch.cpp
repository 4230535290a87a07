#include "core/param/stretch.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "core/charts/chart_surface.h"
#include "core/param/rest_shape.h"

namespace chartflood {

namespace {

constexpr double kAreaFloor = 1e-10;    // of the mean area of a triangle in the plane
constexpr double kOwnFloor = 1e-3;      // of the own area there, if it kept that of its chart
constexpr double kLargestRatio = 1e15;  // where a ratio of a vanishing triangle ends

double spaceArea(const ChartSurface& surface, std::size_t triangle) {
  const auto& t = surface.triangles[triangle];
  const glm::dvec3& origin = surface.positions[t[0]];
  return 0.5 * glm::length(
                   glm::cross(surface.positions[t[1]] - origin, surface.positions[t[2]] - origin));
}

/// False where nothing about the triangle can be measured.
bool hasShape(const ChartSurface& surface, std::size_t triangle, double area) {
  double longest = 0;
  for (Index i = 0; i < 3; ++i) {
    longest = std::max(longest, sideLength(surface, static_cast<Index>(3 * triangle + i)));
  }
  return 2 * area > kNoShape * longest * longest;
}

/// Areas of the chart that its triangles are compared with.
struct ComparedAreas {
  double space = 0;        // of the surface
  double plane = 0;        // sum of the absolute areas
  bool clockwise = false;  // most of the plane area is
};

ComparedAreas chartAreas(const ChartSurface& surface, std::span<const glm::dvec2> uv) {
  ComparedAreas areas;
  std::ptrdiff_t majority = 0;
  for (std::size_t t = 0; t < surface.triangleCount(); ++t) {
    const auto& v = surface.triangles[t];
    const double area = signedArea(uv[v[0]], uv[v[1]], uv[v[2]]);
    areas.space += spaceArea(surface, t);
    areas.plane += std::abs(area);
    majority += area < 0 ? -1 : 1;
  }
  areas.clockwise = majority < 0;
  return areas;
}

/// \param factor plane area of the chart over its area in space
TriangleDistortion distortionOf(const std::array<glm::dvec3, 3>& q,
                                const std::array<glm::dvec2, 3>& p, double planeArea,
                                double spaceArea, double factor) {
  // Partial derivatives of the map from the plane to space (Sander 2001, section 3), from edges:
  // with places, thin triangles would show the roundings of where they lie.
  const double half = 0.5 / planeArea;
  const glm::dvec3 q1 = q[1] - q[0], q2 = q[2] - q[0];
  const glm::dvec2 p1 = p[1] - p[0], p2 = p[2] - p[0];
  const glm::dvec3 s = half * (q1 * p2.y - q2 * p1.y), t = half * (q2 * p1.x - q1 * p2.x);
  const double a = glm::dot(s, s), c = glm::dot(t, t);
  const double product = spaceArea / planeArea;  // of the singular values
  // (s1 + s2)^2 and (s1 - s2)^2; rounding may take the second below 0.
  const double sum = std::sqrt(a + c + 2 * product);
  const double difference = std::sqrt(std::max(0.0, a + c - 2 * product));
  const double largest = 0.5 * (sum + difference);
  TriangleDistortion d;
  d.l2 = std::min(std::sqrt(0.5 * (a + c) * factor), kLargestRatio);
  d.linf = std::min(largest * std::sqrt(factor), kLargestRatio);
  d.areaRatio = std::clamp(1 / (product * factor), 1 / kLargestRatio, kLargestRatio);
  d.angle = std::min(largest * largest / product, kLargestRatio);
  return d;
}

}  // namespace

double surfaceArea(const ChartSurface& surface) {
  double sum = 0;
  for (std::size_t t = 0; t < surface.triangleCount(); ++t) sum += spaceArea(surface, t);
  return sum;
}

std::vector<TriangleDistortion> triangleDistortion(const ChartSurface& surface,
                                                   std::span<const glm::dvec2> uv) {
  std::vector<TriangleDistortion> result(surface.triangleCount());
  const ComparedAreas areas = chartAreas(surface, uv);
  const double count = static_cast<double>(surface.triangleCount());
  const double least = kAreaFloor * areas.plane / count;
  const double factor = areas.plane / areas.space;
  for (std::size_t t = 0; t < result.size(); ++t) {
    const auto& v = surface.triangles[t];
    const std::array<glm::dvec2, 3> p{uv[v[0]], uv[v[1]], uv[v[2]]};
    const double plane = signedArea(p[0], p[1], p[2]);
    const double space = spaceArea(surface, t);
    if (std::isfinite(factor) && factor > 0 && hasShape(surface, t, space)) {
      result[t] = distortionOf(
          {surface.positions[v[0]], surface.positions[v[1]], surface.positions[v[2]]}, p,
          std::max(std::abs(plane), std::min(least, kOwnFloor * space * factor)), space, factor);
    }
    result[t].flipped = plane != 0 && (plane < 0) != areas.clockwise;
  }
  return result;
}

Distortion chartDistortion(const ChartSurface& surface,
                           std::span<const TriangleDistortion> triangles) {
  Distortion d;
  double total = 0, square = 0, area = 0, angle = 0, linf = 0;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const TriangleDistortion& one = triangles[t];
    const double weight = spaceArea(surface, t);
    d.flipped += one.flipped ? 1 : 0;
    if (!hasShape(surface, t, weight)) {
      ++d.shapeless;
      continue;
    }
    total += weight;
    square += weight * one.l2 * one.l2;
    area += weight * std::max(one.areaRatio, 1 / one.areaRatio);
    angle += weight * one.angle;
    linf = std::max(linf, one.linf);
  }
  if (!(total > 0)) return d;
  d.l2 = std::sqrt(square / total);
  d.linf = linf;
  d.area = area / total;
  d.angle = angle / total;
  return d;
}

}  // namespace chartflood
