#include "render/scene/mode_range.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace chartflood {

std::vector<float> balanceValues(std::span<const double> gaussArea) {
  const double sum = std::accumulate(gaussArea.begin(), gaussArea.end(), 0.0);
  const double mean = gaussArea.empty() ? 0 : sum / static_cast<double>(gaussArea.size());
  std::vector<float> balance;
  for (const double area : gaussArea) {
    balance.push_back(mean > 1e-9 ? static_cast<float>(100 * (area / mean - 1)) : 0.0f);
  }
  return balance;
}

ScalarRange balanceRange(std::span<const float> balance) {
  double largest = 0;
  for (const float value : balance) largest = std::max(largest, std::abs(double{value}));
  ScalarRange range;
  // Never less than 10 %: a good balance shall look white.
  range.max = std::clamp(std::ceil(largest / 10) * 10, 10.0, 100.0);
  range.min = -range.max;
  return range;
}

ScalarRange distortionRange(ColorMode mode, std::span<const float> values,
                            std::span<const double> areas) {
  std::vector<WeightedValue> sizes;
  sizes.reserve(values.size());
  const bool signedValues = mode == ColorMode::AreaDistortion;
  for (std::size_t t = 0; t < values.size(); ++t) {
    const double value = double{values[t]};
    sizes.push_back({signedValues ? std::abs(value) : value, areas[t]});
  }
  ScalarRange range;
  if (signedValues) {
    range.max = std::max(std::ceil(weightedPercentile(sizes, 0.98) * 2) / 2, 0.5);
    range.min = -range.max;
    return range;
  }
  range.min = 1;
  // Never less than 1.1, or the noise of a good unwrap would look like a bad one.
  range.max = std::max(std::ceil(weightedPercentile(sizes, 0.98) * 20) / 20, 1.1);
  range.hasMean = true;
  range.mean = weightedMean(sizes);
  return range;
}

ScalarRange chosenRange(ScalarRange range, const RenderSettings& settings) {
  if (settings.scale) range.scale = *settings.scale;
  if (settings.range && settings.range->first < settings.range->second) {
    range.min = settings.range->first;
    range.max = settings.range->second;
  }
  // A logarithm has no place for 0: show four decades below the top.
  if (range.scale == ScalarScale::Log && range.min <= 0) range.min = 1e-4 * std::abs(range.max);
  return range;
}

}  // namespace chartflood
