#include "core/param/thin_charts.h"

#include <utility>
#include <vector>

#include "core/param/chart_shape.h"
#include "core/param/cone_cuts.h"
#include "core/param/rest_shape.h"
#include "core/param/thin_triangles.h"
#include "core/param/unfold.h"

namespace chartflood {

namespace {

/// L2 up to which a chart counts as not stretched: one of thin triangles with more is opened at its
/// cones and rims.
constexpr double kStretchesNot = 1.0005;
/// Length of such cuts, over that of the boundary, at which nobody need ask what the chart would
/// stretch without; and the most they may take.
constexpr double kCheapConeCuts = 0.01, kMostConeCuts = 1;

/// The unfolded chart, opened at its cones and rims, if that lays it flat without stretch.
std::optional<RelievedChart> openedAndUnfolded(const CutChart& chart, double mostCuts) {
  CutChart open = chart;
  if (!openCones(open, mostCuts)) return {};
  FlatAttempt flat;
  {
    const ChartShape shape(open.surface);
    std::vector<glm::dvec2> uv = unfoldedMap(shape);
    if (uv.empty()) return {};
    flat = measuredMap(shape, std::move(uv));
  }
  return RelievedChart{std::move(flat), std::move(open)};
}

}  // namespace

std::optional<RelievedChart> layThinFlat(const CutChart& chart, bool mayCut,
                                         const Progress& progress) {
  const ChartThinness thinness = thinnessOf(chart.surface);
  if (!thinness.any()) return {};
  const ChartShape shape(chart.surface);
  std::vector<glm::dvec2> exact = unfoldedMap(shape);
  if (!exact.empty() && (thinness.mostlyThin || sturdy(shape.rest, exact))) {
    return RelievedChart{measuredMap(shape, std::move(exact)), {}};
  }
  const bool opens = thinness.mostlyThin && mayCut;
  if (opens) {
    if (auto cheap = openedAndUnfolded(chart, kCheapConeCuts)) return cheap;
  }
  if (exact.empty() && !opens) return {};
  FlatAttempt solved = layFlat(shape, UnwrapOptions::Boundary::Free, progress);
  if (solved.keeps(kStretchesNot) || progress.cancelled()) {
    return RelievedChart{std::move(solved), {}};
  }
  if (!exact.empty()) return RelievedChart{measuredMap(shape, std::move(exact)), {}};
  return openedAndUnfolded(chart, kMostConeCuts);
}

}  // namespace chartflood
