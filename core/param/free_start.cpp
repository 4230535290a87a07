#include "core/param/free_start.h"

#include <cmath>
#include <complex>
#include <utility>

#include <glm/geometric.hpp>

namespace chartflood {

namespace {

using Complex = std::complex<double>;

/// Two boundary vertices about as far apart as any: the farthest from any, then the farthest from
/// that one.
std::pair<Index, Index> farBoundaryPair(const ChartShape& shape) {
  const auto farthest = [&](Index from) {
    Index best = kNone;
    double bestDistance = -1;
    for (const Index v : shape.boundary) {
      const glm::dvec3 d = shape.surface.positions[v] - shape.surface.positions[from];
      if (v == from || !(glm::dot(d, d) > bestDistance)) continue;
      best = v;
      bestDistance = glm::dot(d, d);
    }
    return best;
  };
  const Index first = farthest(shape.boundary.front());
  return {first, farthest(first)};
}

/// Cotangent weight of each side from its own triangle: minus the product of the gradients.
std::vector<double> sideWeights(const RestShape& rest) {
  std::vector<double> weight(3 * rest.triangleCount());
  for (std::size_t t = 0; t < rest.triangleCount(); ++t) {
    const glm::dvec2 g1 = rest.gradient[t][0], g2 = rest.gradient[t][1], g0 = -g1 - g2;
    weight[3 * t] = -rest.weight[t] * glm::dot(g0, g1);
    weight[3 * t + 1] = -rest.weight[t] * glm::dot(g1, g2);
    weight[3 * t + 2] = -rest.weight[t] * glm::dot(g2, g0);
  }
  return weight;
}

}  // namespace

std::vector<glm::dvec2> conformalMap(const ChartShape& shape) {
  const ChartSurface& s = shape.surface;
  const auto pins = farBoundaryPair(shape);
  const Index pinA = pins.first, pinB = pins.second;
  std::vector<glm::dvec2> x(shape.rest.vertexCount(), glm::dvec2(0));
  const glm::dvec2 at(1, 0);  // of pinA; pinB stays at the origin
  SparseLdl<Complex> system(shape.pattern);
  system.clear();
  for (const Index pin : {pinA, pinB}) system.addDiagonal(pin, 1);
  x[pinA] = at;
  const auto add = [&](Index side, const Complex& entry) {
    const Index a = s.sideStart(side), b = s.sideEnd(side);
    const bool fixedA = a == pinA || a == pinB, fixedB = b == pinA || b == pinB;
    if (!fixedA && !fixedB) system.addSide(side, entry);
    // What a pin does to its neighbours goes to the right hand side.
    if (!fixedA && b == pinA) x[a] -= glm::dvec2(entry.real(), entry.imag());
    if (!fixedB && a == pinA) x[b] -= glm::dvec2(entry.real(), -entry.imag());
  };
  const std::vector<double> weight = sideWeights(shape.rest);
  for (Index side = 0; side < weight.size(); ++side) {
    const Index a = s.sideStart(side), b = s.sideEnd(side);
    for (const Index v : {a, b}) {
      if (v != pinA && v != pinB) system.addDiagonal(v, weight[side]);
    }
    add(side, -weight[side]);
    // The area inside the boundary, which the Dirichlet energy exceeds by the conformal one.
    if (s.opposite[side] == kNone) add(side, Complex(0, 0.5));
  }
  if (!system.factor()) return {};
  system.solve(x);
  if (!scaleToUnitArea(shape.rest, x)) return {};
  return x;
}

bool localGlobalSteps(const ChartShape& shape, int steps, const Progress& progress,
                      std::vector<glm::dvec2>& uv) {
  const RestShape& rest = shape.rest;
  // Holds the centre in place; far below all weights.
  constexpr double kAnchor = 1e-8;
  SparseLdl<double> system(shape.pattern);
  system.clear();
  const std::vector<double> weight = sideWeights(rest);
  for (Index side = 0; side < weight.size(); ++side) {
    system.addDiagonal(shape.surface.sideStart(side), weight[side]);
    system.addDiagonal(shape.surface.sideEnd(side), weight[side]);
    system.addSide(side, -weight[side]);
  }
  for (Index v = 0; v < rest.vertexCount(); ++v) system.addDiagonal(v, kAnchor);
  if (!system.factor()) return false;
  std::vector<glm::dvec2> x(uv.size());
  double before = 0;
  for (int step = 0; step < steps && !progress.cancelled(); ++step) {
    for (std::size_t v = 0; v < uv.size(); ++v) x[v] = kAnchor * uv[v];
    double energy = 0;
    for (std::size_t t = 0; t < rest.triangleCount(); ++t) {
      const PlaneMap map = planeMap(rest, t, uv);
      const double length = std::sqrt(std::norm(map.alpha));  // far from both ends of the range
      const Complex turn = length > 0 ? map.alpha / length : Complex(1, 0);
      energy += 2 * rest.weight[t] * (std::norm(map.alpha - turn) + std::norm(map.beta));
      const auto pull = [&](const glm::dvec2& g) {
        return rest.weight[t] * glm::dvec2(turn.real() * g.x - turn.imag() * g.y,
                                           turn.imag() * g.x + turn.real() * g.y);
      };
      const glm::dvec2 p1 = pull(rest.gradient[t][0]), p2 = pull(rest.gradient[t][1]);
      x[rest.triangles[t][0]] -= p1 + p2;
      x[rest.triangles[t][1]] += p1;
      x[rest.triangles[t][2]] += p2;
    }
    if (step > 0 && before - energy <= 1e-3 * before) break;
    before = energy;
    system.solve(x);
    uv.swap(x);
  }
  return true;
}

}  // namespace chartflood
