#include "core/param/flat_attempt.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/param/circle_map.h"
#include "core/param/free_map.h"

namespace chartflood {

namespace {

std::size_t badTriangles(const ChartSurface& surface, std::span<const glm::dvec2> uv) {
  return static_cast<std::size_t>(
      std::count_if(surface.triangles.begin(), surface.triangles.end(), [&](const auto& t) {
        return !(signedArea(uv[t[0]], uv[t[1]], uv[t[2]]) > 0);
      }));
}

}  // namespace

bool better(const FlatAttempt& a, const FlatAttempt& b) {
  if (a.flat() != b.flat()) return a.flat();
  if (a.bad != b.bad) return a.bad < b.bad;
  return a.stretch() < b.stretch();
}

FlatAttempt measuredMap(const ChartShape& shape, std::vector<glm::dvec2> places) {
  const ChartSurface& surface = shape.surface;
  FlatAttempt attempt;
  std::vector<glm::dvec2>& uv = attempt.chart.uv;
  uv = std::move(places);
  if (uv.empty() || !scaleToUnitArea(shape.rest, uv)) {
    uv.clear();
    attempt.chart.problem = "Its equations have no solution, so it is not laid flat.";
    return attempt;
  }
  // A chart without area in space keeps that of the thin triangles that stand in for its own.
  const double area = surfaceArea(surface);
  const double unit = area > 0 ? std::sqrt(area) : shape.rest.unit;
  for (glm::dvec2& p : uv) p *= unit;
  attempt.bad = badTriangles(surface, uv);
  attempt.triangles = triangleDistortion(surface, uv);
  attempt.chart.distortion = chartDistortion(surface, attempt.triangles);
  return attempt;
}

FlatAttempt flatOrCircle(const ChartShape& shape, std::vector<glm::dvec2> places) {
  if (places.empty() || !allPositive(shape.rest, places)) {
    places = circleMap(shape, CircleWeights::Uniform);
  }
  return measuredMap(shape, std::move(places));
}

FlatAttempt layFlat(const ChartShape& shape, UnwrapOptions::Boundary boundary,
                    const Progress& progress) {
  return flatOrCircle(shape, boundary == UnwrapOptions::Boundary::Free
                                 ? freeMap(shape, progress)
                                 : circleMap(shape, CircleWeights::Conformal));
}

}  // namespace chartflood
