#include "core/param/thin_triangles.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

namespace chartflood {

namespace {

/// Newton steps of all other triangles would have to follow one that is thinner, unless most are.
constexpr double kSliver = 1e-4;
/// What makes a body of long triangles; those of a well made mesh are above 0.1.
constexpr double kThin = 0.05;
constexpr double kMostly = 0.5;     // of the area
constexpr double kFewArea = 1e-2;   // of the area, in triangles that may be thinner than usual
constexpr double kWellBelow = 0.1;  // of what is usual

/// The thinness that a share of the area falls below.
double thinnessAt(const ChartSurface& surface, double share) {
  std::vector<std::pair<double, double>> each;  // thinness and area
  double total = 0;
  for (std::size_t t = 0; t < surface.triangleCount(); ++t) {
    const FlatTriangle flat = flatTriangle(surface, t);
    each.emplace_back(flat.thinness(), flat.area());
    total += flat.area();
  }
  std::sort(each.begin(), each.end());
  double sum = 0;
  for (const auto& [thinness, area] : each) {
    sum += area;
    if (sum > share * total) return thinness;
  }
  return 0;
}

}  // namespace

FlatTriangle::FlatTriangle(const std::array<glm::dvec3, 3>& p) {
  std::array<glm::dvec3, 3> side;
  std::array<double, 3> size;
  for (std::size_t i = 0; i < 3; ++i) {
    side[i] = p[(i + 1) % 3] - p[i];
    size[i] = glm::length(side[i]);
    if (size[i] > size[longest]) longest = i;
  }
  const std::size_t first = longest;
  const std::size_t second = (first + 1) % 3, third = (first + 2) % 3;
  const double along = size[first];
  edge[first] = {along, 0};
  edge[second] = edge[third] = {0, 0};
  if (!(along > 0)) return;
  const std::size_t shortest = size[second] < size[third] ? second : third;
  const double height = glm::length(glm::cross(side[first], side[shortest])) / along;
  edge[second] = {glm::dot(side[first], side[second]) / along, height};
  edge[third] = {glm::dot(side[first], side[third]) / along, -height};
}

double FlatTriangle::shortest() const {
  return std::min({glm::length(edge[0]), glm::length(edge[1]), glm::length(edge[2])});
}

FlatTriangle flatTriangle(const ChartSurface& surface, std::size_t triangle) {
  const auto& t = surface.triangles[triangle];
  return FlatTriangle({surface.positions[t[0]], surface.positions[t[1]], surface.positions[t[2]]});
}

ChartThinness thinnessOf(const ChartSurface& surface) {
  ChartThinness chart;
  chart.usual = kSliver;
  double thin = 0, total = 0;
  for (const auto& t : surface.triangles) {
    // Every chart is looked at: squares will do.
    const glm::dvec3 &a = surface.positions[t[0]], &b = surface.positions[t[1]],
                     &c = surface.positions[t[2]];
    const glm::dvec3 ab = b - a, bc = c - b, ca = a - c;
    const double longest = std::max({glm::dot(ab, ab), glm::dot(bc, bc), glm::dot(ca, ca)});
    const double doubled = glm::length(glm::cross(ab, bc));
    total += doubled;
    if (doubled < kThin * longest) thin += doubled;
    if (!(doubled >= kSliver * longest)) chart.slivers = true;
  }
  chart.mostlyThin = total > 0 && thin >= kMostly * total;
  if (chart.slivers) {
    const double usual = kWellBelow * thinnessAt(surface, kFewArea);
    if (usual > kNoShape) chart.usual = std::min(usual, kSliver);
  }
  return chart;
}

}  // namespace chartflood
