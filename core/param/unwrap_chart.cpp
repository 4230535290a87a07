#include "core/param/unwrap_chart.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/charts/boundary_cut.h"
#include "core/param/chart_shape.h"
#include "core/param/circle_map.h"
#include "core/param/cone_cuts.h"
#include "core/param/free_map.h"
#include "core/param/rest_shape.h"
#include "core/param/unfold.h"

namespace chartflood {

namespace {

constexpr std::size_t kMostReliefCuts = 8;
constexpr std::size_t kPatience = 3;  // cuts in a row that may fail to help
constexpr double kWorthwhile = 0.97;  // factor on L2 that a cut has to reach
constexpr double kDeepEnough = 0.1;   // of the greatest distance from the boundary
/// A circle squeezes the boundary of every chart, so its L2 is 2 to 4 on charts that need no slit.
/// Measured limits of 1.5, 3, 4, 6 and 10 for a mean L2 of the armadillo's 20 charts of 4.4, 3.5,
/// 3.2, 3.0 and 4.6 with 129, 52, 34, 9 and 1 cuts: slits have a boundary to squeeze themselves.
constexpr double kCircleFactor = 4;
/// L2 up to which a chart counts as not stretched: one of thin triangles with more is opened at its
/// cones and rims.
constexpr double kStretchesNot = 1.0005;
/// Length of such cuts, over that of the boundary, at which nobody need ask what the chart would
/// stretch without; and the most they may take.
constexpr double kCheapCuts = 0.01, kMostCuts = 1;

/// Triangles that are not counter-clockwise.
std::size_t badTriangles(const ChartSurface& surface, std::span<const glm::dvec2> uv) {
  return static_cast<std::size_t>(
      std::count_if(surface.triangles.begin(), surface.triangles.end(), [&](const auto& t) {
        return !(signedArea(uv[t[0]], uv[t[1]], uv[t[2]]) > 0);
      }));
}

std::vector<glm::dvec2> flatten(const ChartShape& shape, UnwrapOptions::Boundary boundary,
                                const std::vector<glm::dvec2>& before, const Progress& progress) {
  std::vector<glm::dvec2> uv = boundary == UnwrapOptions::Boundary::Free
                                   ? freeMap(shape, before, progress)
                                   : circleMap(shape, CircleWeights::Conformal);
  if (!uv.empty() && allPositive(shape.rest, uv)) return uv;
  return circleMap(shape, CircleWeights::Uniform);
}

struct Attempt {
  FlatChart flat;
  std::size_t bad = 0;
};

/// Scales and measures a map; an empty one is a problem.
Attempt measured(const ChartShape& shape, std::vector<glm::dvec2> places) {
  const ChartSurface& surface = shape.surface;
  Attempt attempt;
  std::vector<glm::dvec2>& uv = attempt.flat.chart.uv;
  uv = std::move(places);
  if (uv.empty() || !scaleToUnitArea(shape.rest, uv)) {
    uv.clear();
    attempt.flat.chart.problem = "Its equations have no solution, so it is not laid flat.";
    return attempt;
  }
  // A chart without area in space keeps that of the thin triangles that stand in for its own.
  const double area = surfaceArea(surface);
  const double unit = area > 0 ? std::sqrt(area) : shape.rest.unit;
  for (glm::dvec2& p : uv) p *= unit;
  attempt.bad = badTriangles(surface, uv);
  attempt.flat.triangles = triangleDistortion(surface, uv);
  attempt.flat.chart.distortion = chartDistortion(surface, attempt.flat.triangles);
  return attempt;
}

Attempt layFlat(const ChartShape& shape, const UnwrapOptions& options,
                const std::vector<glm::dvec2>& before, const Progress& progress) {
  return measured(shape, flatten(shape, options.boundary, before, progress));
}

/// The unfolded chart, opened at its cones and rims, if that lays it flat without stretch.
std::optional<Attempt> openedAndUnfolded(const CutChart& chart, double mostCuts,
                                         std::optional<CutChart>& relieved) {
  CutChart open = chart;
  if (!openCones(open, mostCuts)) return {};
  const ChartShape shape(open.surface);
  std::vector<glm::dvec2> uv = unfoldedMap(shape);
  if (uv.empty()) return {};
  Attempt attempt = measured(shape, std::move(uv));
  relieved = std::move(open);
  return attempt;
}

/// Lays a chart flat with a free boundary. What is made of thin triangles is mostly developable, and
/// equations follow thin triangles badly: such a chart is unfolded exactly where it can be. Where
/// only some are thin, so much that they might flip when places are rounded, the equations widen
/// them; that stretches nothing that has an area.
Attempt layThinFlat(const CutChart& chart, const ChartShape& shape, const UnwrapOptions& options,
                    std::optional<CutChart>& relieved, const Progress& progress) {
  const ChartThinness& thinness = shape.rest.thinness;
  std::vector<glm::dvec2> exact;
  if (thinness.any()) exact = unfoldedMap(shape);
  if (!exact.empty() && (thinness.mostlyThin || sturdy(shape.rest, exact))) {
    return measured(shape, std::move(exact));
  }
  const bool opens = thinness.mostlyThin && options.reliefStretch > 0;
  if (opens) {
    if (auto cheap = openedAndUnfolded(chart, kCheapCuts, relieved)) return *std::move(cheap);
  }
  Attempt solved = layFlat(shape, options, {}, progress);
  const bool stretched = !(solved.flat.chart.distortion.l2 <= kStretchesNot) || solved.bad > 0;
  if (!stretched || progress.cancelled()) return solved;
  if (!exact.empty()) return measured(shape, std::move(exact));
  if (!opens) return solved;
  auto opened = openedAndUnfolded(chart, kMostCuts, relieved);
  return opened ? *std::move(opened) : std::move(solved);
}

/// The inner vertex to slit from: of the triangle that shrank most, and not near the boundary.
/// Where triangles vanished it is one of theirs wherever it lies, rather one with no others: two
/// edges between the same two vertices leave no room for what is between them, until it is slit.
Index reliefVertex(const ChartSurface& surface, const Attempt& attempt) {
  const std::vector<double> depth = distanceToBoundary(surface);
  const std::span<const glm::dvec2> uv = attempt.flat.chart.uv;
  double deepest = 0;
  for (const double d : depth) {
    if (std::isfinite(d)) deepest = std::max(deepest, d);
  }
  std::vector<bool> sound(surface.vertexCount(), false);  // has a counter-clockwise triangle
  for (const auto& t : surface.triangles) {
    if (!(signedArea(uv[t[0]], uv[t[1]], uv[t[2]]) > 0)) continue;
    for (const Index v : t) sound[v] = true;
  }
  const double least = attempt.bad > 0 ? 0 : kDeepEnough * deepest;
  Index best = kNone;
  double bestRatio = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < surface.triangleCount(); ++i) {
    const auto& t = surface.triangles[i];
    const bool bad = attempt.bad > 0 && !(signedArea(uv[t[0]], uv[t[1]], uv[t[2]]) > 0);
    if (attempt.bad > 0 && !bad) continue;
    for (const Index v : t) {
      if (!std::isfinite(depth[v]) || !(depth[v] > least)) continue;
      const double ratio = bad ? (sound[v] ? 1 : 0) : attempt.flat.triangles[i].areaRatio;
      if (ratio < bestRatio || (ratio == bestRatio && depth[v] > depth[best])) {
        best = v;
        bestRatio = ratio;
      }
    }
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

bool clearlyBetter(const Attempt& a, const Attempt& b) {
  if (a.bad != b.bad) return a.bad < b.bad;
  return a.flat.chart.distortion.l2 < kWorthwhile * b.flat.chart.distortion.l2;
}

/// Cuts while the chart stretches more than `limit`, and keeps the cuts that helped: `relieved` has
/// them, if any did.
void relieve(const CutChart& chart, Attempt& best, std::optional<CutChart>& relieved, double limit,
             const UnwrapOptions& options, const Progress& progress) {
  const auto well = [&](const Attempt& attempt) {
    return attempt.bad == 0 && !(attempt.flat.chart.distortion.l2 > limit);
  };
  if (well(best)) return;
  CutChart trial = chart;
  Attempt last = best;
  std::size_t waited = 0;
  for (std::size_t cuts = 0; cuts < kMostReliefCuts && waited < kPatience; ++cuts) {
    if (progress.cancelled() || last.flat.chart.uv.empty()) return;
    if (well(last)) return;
    const Index vertex = reliefVertex(trial.surface, last);
    const auto triangles = trial.surface.triangles;
    if (vertex == kNone || !cutToBoundary(trial, vertex, CutReason::Relief)) return;
    const auto before = carriedOver(triangles, last.flat.chart.uv, trial.surface);
    last = layFlat(ChartShape(trial.surface), options, before, progress);
    ++waited;
    if (last.flat.chart.uv.empty() || !clearlyBetter(last, best)) continue;
    best = last;
    relieved = trial;
    waited = 0;
  }
}

}  // namespace

FlatChart unwrapChart(const CutChart& chart, const UnwrapOptions& options,
                      const Progress& progress) {
  if (!chart.disk()) {
    FlatChart none;
    none.chart.problem = chart.problem;
    return none;
  }
  const bool circle = options.boundary == UnwrapOptions::Boundary::Circle;
  std::optional<CutChart> relieved;
  Attempt best;
  {
    const ChartShape shape(chart.surface);
    best = circle ? layFlat(shape, options, {}, progress)
                  : layThinFlat(chart, shape, options, relieved, progress);
  }
  const double factor = circle ? kCircleFactor : 1;
  if (options.reliefStretch > 0 && !relieved) {
    relieve(chart, best, relieved, factor * options.reliefStretch, options, progress);
  }
  if (circle && !progress.cancelled()) {
    const ChartShape shape(relieved ? relieved->surface : chart.surface);
    if (!best.flat.chart.uv.empty() && !sturdy(shape.rest, best.flat.chart.uv)) {
      std::vector<glm::dvec2> uv = sturdyCircleMap(shape, progress);
      if (!uv.empty()) best = measured(shape, std::move(uv));
    }
  }
  best.flat.relieved = std::move(relieved);
  return std::move(best.flat);
}

}  // namespace chartflood
