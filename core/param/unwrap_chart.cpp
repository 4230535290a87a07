#include "core/param/unwrap_chart.h"

#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "core/param/circle_map.h"
#include "core/param/free_map.h"
#include "core/param/relief_cuts.h"
#include "core/param/thin_charts.h"

namespace chartflood {

namespace {

/// A circle squeezes the boundary of every chart, so its L2 is 2 to 4 on charts that need no slit.
/// Measured limits of 1.5, 3, 4, 6 and 10 for a mean L2 of the armadillo's 20 charts of 4.4, 3.5,
/// 3.2, 3.0 and 4.6 with 129, 52, 34, 9 and 1 cuts: slits have a boundary to squeeze themselves.
constexpr double kCircleFactor = 4;

/// False when a sketch has flips, covers itself or stretches more than it may.
bool sketchFlat(const CutChart& chart, const UnwrapOptions& options, const Progress& progress,
                FlatAttempt& flat) {
  const ChartShape shape(chart.surface);
  std::vector<glm::dvec2> places = sketchedMap(shape, progress);
  if (places.empty()) return false;
  flat = measuredMap(shape, std::move(places));
  return flat.keeps(options.reliefStretch > 0 ? reliefLimit(options)
                                              : std::numeric_limits<double>::infinity());
}

}  // namespace

double reliefLimit(const UnwrapOptions& options) {
  const bool circle = options.boundary == UnwrapOptions::Boundary::Circle;
  return (circle ? kCircleFactor : 1) * options.reliefStretch;
}

FlatChart unwrapChart(const CutChart& chart, const UnwrapOptions& options,
                      const Progress& progress) {
  if (!chart.disk()) {
    FlatChart none;
    none.chart.problem = chart.problem;
    return none;
  }
  const bool circle = options.boundary == UnwrapOptions::Boundary::Circle;
  const bool mayCut = options.reliefStretch > 0;
  RelievedChart done;
  std::optional<RelievedChart> thin;
  if (!circle) thin = layThinFlat(chart, mayCut, progress);
  if (thin) {
    done = *std::move(thin);
  } else if (!circle && options.sketch && sketchFlat(chart, options, progress, done.flat)) {
    // It does for a look.
  } else if (mayCut) {
    done = layFlatWithin(reliefLimit(options), chart, options.boundary, progress);
  } else {
    done.flat = layFlat(ChartShape(chart.surface), options.boundary, progress);
  }
  if (circle && !progress.cancelled()) {
    const ChartShape shape(done.chart ? done.chart->surface : chart.surface);
    if (done.flat.flat() && !sturdy(shape.rest, done.flat.chart.uv)) {
      std::vector<glm::dvec2> uv = sturdyCircleMap(shape, progress);
      if (!uv.empty()) done.flat = measuredMap(shape, std::move(uv));
    }
  }
  return {std::move(done.flat.chart), std::move(done.flat.triangles), std::move(done.chart)};
}

}  // namespace chartflood
