#pragma once
/// How the values of a colour mode are spread over the surface, in the legend's own range and
/// scale.

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "app/host/insight/surface_derived.h"
#include "core/session/session.h"
#include "render/scene/render_settings.h"
#include "render/scene/scalar_range.h"

namespace chartflood {

/// Shares of a total weight, in bins that are evenly wide on the colour bar.
struct Histogram {
  /// Of each bin, in [0, 1]; they sum to 1, or to 0 without values, in a flood to its taken share.
  std::vector<double> share;
  double below = 0;    ///< share under the range, counted in the first bin
  double above = 0;    ///< share over the range, counted in the last bin
  double missing = 0;  ///< share of all weight that has no value (NaN); not in the bins
};

/// Values without weight are left out. Cost: linear.
/// \pre bins > 0
Histogram binValues(std::span<const WeightedValue> values, const ScalarRange& range,
                    std::size_t bins);

/// The value at a place on the colour bar, in [0, 1]: the inverse of ScalarRange::place().
double valueAt(const ScalarRange& range, double place);

/// The histogram of one kind of elements.
struct ModeHistogram {
  ScalarRange range;   ///< as the legend shows it; title and unit filled
  std::string weight;  ///< what the shares are of: "of the surface"
  Histogram histogram;
};

/// What histograms are made from; parts may be null.
struct HistogramSource {
  std::shared_ptr<const SurfaceDerived> surface;
  std::shared_ptr<const Mesh> mesh;
  std::shared_ptr<const ChartStats> stats;  ///< of the moment
  std::shared_ptr<const Unwrap> unwrap;
  std::shared_ptr<const FloodRecord> record;
  std::size_t recorded = 0;  ///< entries that `record` had
  std::size_t taken = 0;     ///< the first so many of them are to be counted
};

/// One histogram for most modes, three for Gauss area of all elements (faces, edges, vertices),
/// none for modes without values or where they are not computed yet. Triangles count by their area,
/// creases by their length, corners once, charts by their area. Cost: linear.
std::vector<ModeHistogram> modeHistograms(const HistogramSource& source,
                                          const RenderSettings& settings);

}  // namespace chartflood
