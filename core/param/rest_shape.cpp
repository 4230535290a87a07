#include "core/param/rest_shape.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace chartflood {

namespace {

/// Shortest longest edge of a triangle, over the mean edge of the chart.
constexpr double kLeastEdge = 1e-2;
constexpr double kSturdyHeight = 1e-7;

/// Corners in the plane, the longest edge along x. The height grows to the least one where it is
/// below; its foot stays where it is, as to move it would shear the triangle.
std::array<glm::dvec2, 3> layFlat(const std::array<glm::dvec3, 3>& p, double leastEdge,
                                  double leastHeight) {
  int first = 0;
  double longest = -1;
  for (int i = 0; i < 3; ++i) {
    const double length = glm::distance(p[i], p[(i + 1) % 3]);
    if (length > longest) {
      longest = length;
      first = i;
    }
  }
  const glm::dvec3 edge = p[(first + 1) % 3] - p[first];
  const glm::dvec3 side = p[(first + 2) % 3] - p[first];
  double along = 0.5, height = 0;
  if (longest > 0) {
    along = std::clamp(glm::dot(edge, side) / (longest * longest), 0.0, 1.0);
    height = glm::length(glm::cross(edge, side)) / longest;
  }
  if (!(longest > leastEdge)) {
    if (height < leastHeight * longest) height = leastEdge / 2;
    longest = leastEdge;
  }
  height = std::max(height, leastHeight * longest);
  std::array<glm::dvec2, 3> flat;
  flat[first] = {0, 0};
  flat[(first + 1) % 3] = {longest, 0};
  flat[(first + 2) % 3] = {along * longest, height};
  return flat;
}

double meanEdge(const ChartSurface& surface) {
  double sum = 0;
  for (const auto& t : surface.triangles) {
    for (int i = 0; i < 3; ++i) {
      sum += glm::distance(surface.positions[t[i]], surface.positions[t[(i + 1) % 3]]);
    }
  }
  const double mean = sum / (3.0 * static_cast<double>(surface.triangleCount()));
  // All in one point: any size will do.
  return mean > 0 && std::isfinite(mean) ? mean : 1;
}

}  // namespace

RestShape::RestShape(const ChartSurface& surface)
    : triangles(surface.triangles), vertices(surface.vertexCount()), thinness(thinnessOf(surface)) {
  weight.reserve(triangles.size());
  gradient.reserve(triangles.size());
  const double leastEdge = kLeastEdge * meanEdge(surface);
  double total = 0;
  for (const auto& t : triangles) {
    const auto p =
        layFlat({surface.positions[t[0]], surface.positions[t[1]], surface.positions[t[2]]},
                leastEdge, thinness.usual);
    const glm::dvec2 e1 = p[1] - p[0], e2 = p[2] - p[0];
    const double area2 = e1.x * e2.y - e1.y * e2.x;
    gradient.push_back({glm::dvec2(e2.y, -e2.x) / area2, glm::dvec2(-e1.y, e1.x) / area2});
    weight.push_back(area2 / 2);
    total += area2 / 2;
  }
  unit = std::sqrt(total);
  for (double& w : weight) w /= total;
  for (auto& g : gradient) g = {g[0] * unit, g[1] * unit};
}

PlaneMap planeMap(const RestShape& rest, std::size_t triangle, std::span<const glm::dvec2> uv) {
  const auto& t = rest.triangles[triangle];
  const auto& g = rest.gradient[triangle];
  const glm::dvec2 e1 = uv[t[1]] - uv[t[0]], e2 = uv[t[2]] - uv[t[0]];
  // Columns of the Jacobian.
  const glm::dvec2 x = e1 * g[0].x + e2 * g[1].x, y = e1 * g[0].y + e2 * g[1].y;
  return {{0.5 * (x.x + y.y), 0.5 * (x.y - y.x)}, {0.5 * (x.x - y.y), 0.5 * (x.y + y.x)}};
}

double signedArea(const RestShape& rest, std::span<const glm::dvec2> uv) {
  double sum = 0;
  for (const auto& t : rest.triangles) sum += signedArea(uv[t[0]], uv[t[1]], uv[t[2]]);
  return sum;
}

bool allPositive(const RestShape& rest, std::span<const glm::dvec2> uv) {
  return std::all_of(rest.triangles.begin(), rest.triangles.end(), [&](const auto& t) {
    const double area = signedArea(uv[t[0]], uv[t[1]], uv[t[2]]);
    return area > 0 && std::isfinite(area);
  });
}

bool sturdy(const RestShape& rest, std::span<const glm::dvec2> uv) {
  const double least = kSturdyHeight * std::sqrt(std::abs(signedArea(rest, uv)));
  return std::all_of(rest.triangles.begin(), rest.triangles.end(), [&](const auto& t) {
    const double longest =
        std::max({glm::distance(uv[t[0]], uv[t[1]]), glm::distance(uv[t[1]], uv[t[2]]),
                  glm::distance(uv[t[2]], uv[t[0]])});
    return 2 * signedArea(uv[t[0]], uv[t[1]], uv[t[2]]) > least * longest;
  });
}

bool scaleToUnitArea(const RestShape& rest, std::span<glm::dvec2> uv) {
  const double area = signedArea(rest, uv);
  const double scale = 1 / std::sqrt(std::abs(area));
  if (!std::isfinite(area) || !std::isfinite(scale)) return false;
  glm::dvec2 center{0};
  for (const glm::dvec2& p : uv) center += p;
  center /= static_cast<double>(uv.size());
  const glm::dvec2 factor(area < 0 ? -scale : scale, scale);
  for (glm::dvec2& p : uv) p = factor * (p - center);
  return true;
}

}  // namespace chartflood
