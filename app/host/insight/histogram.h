#pragma once
/// How the values of a colour mode are spread over the surface, in the legend's own range and
/// scale.

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "render/scene/mode_values.h"
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

/// One histogram for most modes, three for Gauss area of all elements (faces, edges, vertices),
/// none for modes without values or where they are not computed yet. Triangles count by their area,
/// creases by their length, corners once, charts by their area. Cost: linear.
std::vector<ModeHistogram> modeHistograms(const ModeSource& source, const RenderSettings& settings);

}  // namespace chartflood
