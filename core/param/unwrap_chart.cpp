#include "core/param/unwrap_chart.h"

#include <cmath>

#include "core/charts/boundary_cut.h"
#include "core/param/chart_shape.h"
#include "core/param/circle_map.h"
#include "core/param/free_map.h"
#include <cstdio>
#include <cstdlib>

namespace chartflood {

namespace {

constexpr std::size_t kMostReliefCuts = 8;
constexpr double kDeepEnough = 0.1;  // of the greatest distance from the boundary

std::vector<glm::dvec2> flatten(const ChartShape& shape, UnwrapOptions::Boundary boundary,
                                const std::vector<glm::dvec2>& before, const Progress& progress) {
  if (boundary == UnwrapOptions::Boundary::Free) {
    std::vector<glm::dvec2> uv = freeMap(shape, before, progress);
    if (!uv.empty()) return uv;
  } else {
    std::vector<glm::dvec2> uv = circleMap(shape, CircleWeights::Conformal);
    if (!uv.empty() && allPositive(shape.rest, uv)) return uv;
  }
  return circleMap(shape, CircleWeights::Uniform);
}

/// The inner vertex to slit from: of the triangle that shrank most, and not near the boundary.
Index reliefVertex(const ChartSurface& surface, std::span<const TriangleDistortion> triangles) {
  const std::vector<double> depth = distanceToBoundary(surface);
  double deepest = 0;
  for (const double d : depth) {
    if (std::isfinite(d)) deepest = std::max(deepest, d);
  }
  Index best = kNone;
  double bestRatio = 0;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    if (best != kNone && !(triangles[t].areaRatio < bestRatio)) continue;
    Index inner = kNone;
    for (const Index v : surface.triangles[t]) {
      if (!std::isfinite(depth[v]) || !(depth[v] > kDeepEnough * deepest)) continue;
      if (inner == kNone || depth[v] > depth[inner]) inner = v;
    }
    if (inner == kNone) continue;
    best = inner;
    bestRatio = triangles[t].areaRatio;
  }
  return best;
}

/// The places of a surface's vertices after a cut gave some of them copies.
/// \param triangles of the surface before the cut
std::vector<glm::dvec2> carriedOver(std::span<const std::array<Index, 3>> triangles,
                                    std::span<const glm::dvec2> uv, const ChartSurface& cut) {
  std::vector<glm::dvec2> places(cut.vertexCount());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (int i = 0; i < 3; ++i) places[cut.triangles[t][i]] = uv[triangles[t][i]];
  }
  return places;
}

}  // namespace

FlatChart unwrapChart(CutChart& chart, const UnwrapOptions& options, const Progress& progress) {
  FlatChart flat;
  if (!chart.disk()) {
    flat.chart.problem = chart.problem;
    return flat;
  }
  std::vector<glm::dvec2> before;
  for (std::size_t cuts = 0; !progress.cancelled(); ++cuts) {
    const ChartShape shape(chart.surface);
    flat.chart.uv = flatten(shape, options.boundary, before, progress);
    if (progress.cancelled()) break;
    if (flat.chart.uv.empty()) {
      flat.chart.problem = "not laid flat: the equations could not be solved";
      break;
    }
    for (glm::dvec2& p : flat.chart.uv) p *= shape.rest.unit;
    flat.triangles = triangleDistortion(chart.surface, flat.chart.uv);
    flat.chart.distortion = chartDistortion(chart.surface, flat.triangles);
    if (options.reliefStretch <= 0 || cuts == kMostReliefCuts) break;
    if (!(flat.chart.distortion.l2 > options.reliefStretch)) break;
    const Index vertex = reliefVertex(chart.surface, flat.triangles);
    const auto triangles = chart.surface.triangles;
    if (vertex == kNone || !cutToBoundary(chart, vertex, CutReason::Relief)) break;
    before = carriedOver(triangles, flat.chart.uv, chart.surface);
  }
  return flat;
}

}  // namespace chartflood
