#include "core/param/circle_map.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <glm/geometric.hpp>

#include "core/param/isometric_energy.h"
#include "core/param/isometric_map.h"

namespace chartflood {

namespace {

constexpr double kLeastArc = 1e-2;     // over the mean arc
constexpr double kLeastWeight = 1e-4;  // keeps weights positive
constexpr double kLargestCotangent = 1e4;
constexpr int kSturdySteps = 30;

/// Boundary vertices on the unit circle, the others at the origin.
std::vector<glm::dvec2> boundaryOnCircle(const ChartShape& shape) {
  const std::size_t n = shape.boundary.size();
  std::vector<double> length(n);
  double total = 0;
  for (std::size_t i = 0; i < n; ++i) {
    length[i] = glm::distance(shape.surface.positions[shape.boundary[i]],
                              shape.surface.positions[shape.boundary[(i + 1) % n]]);
    total += length[i];
  }
  const double least = total > 0 ? kLeastArc * total / static_cast<double>(n) : 1;
  total = 0;
  for (double& l : length) total += l = std::max(l, least);
  std::vector<glm::dvec2> uv(shape.rest.vertexCount(), glm::dvec2(0));
  double walked = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * walked / total;
    uv[shape.boundary[i]] = {std::cos(angle), std::sin(angle)};
    walked += length[i];
  }
  return uv;
}

/// Half the cotangent of the angle across each side, both sides of an edge summed, then clamped.
std::vector<double> edgeWeights(const ChartShape& shape, CircleWeights kind) {
  const ChartSurface& s = shape.surface;
  std::vector<double> weight(s.opposite.size(), 1);
  if (kind == CircleWeights::Uniform) return weight;
  for (Index side = 0; side < weight.size(); ++side) {
    const glm::dvec3& apex = s.positions[s.sideStart(ChartSurface::previousSide(side))];
    const glm::dvec3 a = s.positions[s.sideStart(side)] - apex;
    const glm::dvec3 b = s.positions[s.sideEnd(side)] - apex;
    const double sine = glm::length(glm::cross(a, b));
    const double cotangent = glm::dot(a, b) / sine;
    // 0 / 0: the triangle has no angles and does not pull.
    weight[side] = std::isnan(cotangent)
                       ? 0
                       : 0.5 * std::clamp(cotangent, -kLargestCotangent, kLargestCotangent);
  }
  std::vector<double> sum(weight.size());
  for (Index side = 0; side < sum.size(); ++side) {
    const Index other = s.opposite[side];
    sum[side] = std::max(kLeastWeight, weight[side] + (other == kNone ? 0 : weight[other]));
  }
  return sum;
}

}  // namespace

std::vector<glm::dvec2> circleMap(const ChartShape& shape, CircleWeights kind) {
  const ChartSurface& s = shape.surface;
  const std::vector<double> weight = edgeWeights(shape, kind);
  std::vector<glm::dvec2> uv = boundaryOnCircle(shape);
  SparseLdl<double> system(shape.pattern);
  system.clear();
  std::vector<glm::dvec2> x = uv;
  for (const Index v : shape.boundary) system.addDiagonal(v, 1);
  for (Index side = 0; side < weight.size(); ++side) {
    if (s.opposite[side] < side) continue;  // an edge once
    const Index a = s.sideStart(side), b = s.sideEnd(side);
    const bool fixedA = shape.onBoundary[a], fixedB = shape.onBoundary[b];
    if (!fixedA) system.addDiagonal(a, weight[side]);
    if (!fixedB) system.addDiagonal(b, weight[side]);
    if (!fixedA && !fixedB) system.addSide(side, -weight[side]);
    if (!fixedA && fixedB) x[a] += weight[side] * uv[b];
    if (fixedA && !fixedB) x[b] += weight[side] * uv[a];
  }
  if (!system.factor()) return {};
  system.solve(x);
  if (!scaleToUnitArea(shape.rest, x)) return {};
  return x;
}

std::vector<glm::dvec2> bestCircleMap(const ChartShape& shape) {
  std::vector<glm::dvec2> best;
  double least = std::numeric_limits<double>::infinity();
  for (const CircleWeights weights : {CircleWeights::Conformal, CircleWeights::Uniform}) {
    std::vector<glm::dvec2> uv = circleMap(shape, weights);
    if (uv.empty()) continue;
    const double energy = isometricEnergy(shape.rest, uv);
    if (!(energy < least)) continue;
    least = energy;
    best = std::move(uv);
  }
  return best;
}

std::vector<glm::dvec2> sturdyCircleMap(const ChartShape& shape, const Progress& progress) {
  std::vector<glm::dvec2> uv = bestCircleMap(shape);
  if (uv.empty()) return {};
  for (int step = 0; step < kSturdySteps; ++step) {
    minimiseIsometric(shape, {.steps = 1, .tolerance = 0, .fixBoundary = true}, progress, uv);
    if (sturdy(shape.rest, uv)) return uv;
    if (progress.cancelled()) break;
  }
  return {};
}

}  // namespace chartflood
