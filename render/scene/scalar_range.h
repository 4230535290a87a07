#pragma once
/// The numbers of a scalar bar: range, scale and ticks. No GL.

#include <span>
#include <string>
#include <vector>

#include "render/scene/color_modes.h"

namespace chartflood {

/// What the colours of a picture stand for.
struct ScalarRange {
  double min = 0, max = 1;
  ScalarScale scale = ScalarScale::Linear;
  bool hasMean = false;
  double mean = 0;
  std::string title, unit;
  bool plainEnds = false;  ///< no numbers: the ends are called "low" and "high"

  /// Place of a value on the bar, in [0, 1].
  double place(double value) const;
};

/// A value and its weight (area, length) in a distribution.
struct WeightedValue {
  double value = 0, weight = 1;
};

/// The value below which `share` of the weight of the positive finite values lies, to about 2 %;
/// 0 when there are none. Linear in the number of values.
double weightedPercentile(std::span<const WeightedValue> values, double share);
double weightedMean(std::span<const WeightedValue> values);

/// Range for values that start at 0 and have a long tail: up to the 98th percentile by weight, or
/// to the mean where most of the weight has no value at all.
ScalarRange rangeFromZero(std::span<const WeightedValue> values);

/// Width at the right of a picture that the bar takes with its numbers, pixels at 100 %.
inline constexpr float kScalarBarWidth = 118;
/// Height of the bar alone, pixels; `scale` is RenderSettings::pixelScale.
float scalarBarHeight(float pictureHeight, float scale);

struct ScalarTick {
  double place = 0;  ///< on the bar, in [0, 1]
  std::string label;
};
/// Round numbers inside the range, at most about `count`, evenly enough that labels do not touch;
/// ascending by place.
std::vector<ScalarTick> scalarTicks(const ScalarRange& range, int count);

}  // namespace chartflood
