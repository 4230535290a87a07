#include "render/scene/scalar_range.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace chartflood {

namespace {

// Histogram over the logarithm: 32 bins an octave over all sizes that doubles reach in practice.
constexpr int kBinsPerOctave = 32;
constexpr int kLowestOctave = -120, kHighestOctave = 120;
constexpr std::size_t kBins = (kHighestOctave - kLowestOctave) * kBinsPerOctave;

std::size_t binOf(double value) {
  const double bin = (std::log2(value) - kLowestOctave) * kBinsPerOctave;
  return static_cast<std::size_t>(std::clamp(bin, 0.0, double{kBins - 1}));
}

double binTop(std::size_t bin) {
  return std::exp2(static_cast<double>(bin + 1) / kBinsPerOctave + kLowestOctave);
}

std::string numberText(double value) {
  std::array<char, 32> text{};
  const double size = std::abs(value);
  if (size >= 1e5 || (size > 0 && size < 1e-3)) {
    std::snprintf(text.data(), text.size(), "%.0e", value);
  } else {
    std::snprintf(text.data(), text.size(), "%.4g", value);
  }
  return text.data();
}

/// Round numbers from the roundest on: powers of ten, then 5, then 2 and its like.
std::vector<double> candidates(const ScalarRange& range) {
  std::vector<double> list;
  if (range.min <= 0 && range.max >= 0) list.push_back(0);
  const double largest = std::max(std::abs(range.min), std::abs(range.max));
  if (largest <= 0) return list;
  const int top = static_cast<int>(std::floor(std::log10(largest)));
  for (const double digit : {1.0, 5.0, 2.0}) {
    for (int decade = top; decade > top - 8; --decade) {
      list.push_back(digit * std::pow(10.0, decade));
      list.push_back(-list.back());
    }
  }
  return list;
}

std::vector<double> evenSteps(const ScalarRange& range, int count) {
  const double rough = (range.max - range.min) / std::max(count, 1);
  const double decade = std::pow(10.0, std::floor(std::log10(rough)));
  double step = 10 * decade;
  for (const double digit : {1.0, 2.0, 5.0}) {
    if (digit * decade >= rough * 0.999) {
      step = digit * decade;
      break;
    }
  }
  std::vector<double> list;
  const double first = std::ceil(range.min / step - 1e-6);
  const double last = std::floor(range.max / step + 1e-6);
  for (double i = first; i <= last; ++i) list.push_back(i == 0 ? 0 : i * step);
  return list;
}

}  // namespace

double ScalarRange::place(double value) const {
  if (scale == ScalarScale::Log) {
    return std::clamp(std::log(std::max(value, min) / min) / std::log(max / min), 0.0, 1.0);
  }
  const double t = std::clamp((value - min) / (max - min), 0.0, 1.0);
  return scale == ScalarScale::Root ? std::sqrt(t) : t;
}

double weightedPercentile(std::span<const WeightedValue> values, double share) {
  std::vector<double> weight(kBins, 0.0);
  double total = 0;
  for (const WeightedValue& v : values) {
    if (!(v.weight > 0) || !std::isfinite(v.value)) continue;
    total += v.weight;
    if (v.value > 0) weight[binOf(v.value)] += v.weight;
  }
  // From above, so that values of 0 count as the lower part.
  double above = 0;
  for (std::size_t bin = kBins; bin-- > 0;) {
    above += weight[bin];
    if (above > (1 - share) * total) return binTop(bin);
  }
  return 0;
}

double weightedMean(std::span<const WeightedValue> values) {
  double sum = 0, total = 0;
  for (const WeightedValue& v : values) {
    if (!(v.weight > 0) || !std::isfinite(v.value)) continue;
    sum += v.value * v.weight;
    total += v.weight;
  }
  return total > 0 ? sum / total : 0;
}

ScalarRange rangeFromZero(std::span<const WeightedValue> values) {
  ScalarRange range;
  range.mean = weightedMean(values);
  range.hasMean = range.mean > 0;
  double largest = 0;
  for (const WeightedValue& v : values) largest = std::max(largest, v.weight > 0 ? v.value : 0.0);
  const double top = std::min(std::max(weightedPercentile(values, 0.98), range.mean), largest);
  range.max = top > 0 ? top : 1;
  return range;
}

float scalarBarHeight(float pictureHeight, float scale) {
  return std::round(std::clamp(0.42f * pictureHeight, 60 * scale, 260 * scale));
}

std::vector<ScalarTick> scalarTicks(const ScalarRange& range, int count) {
  if (range.plainEnds) return {{0, "low"}, {1, "high"}};
  // Less than a decade of logarithms holds too few round numbers; even steps look even there.
  const bool narrow = range.scale == ScalarScale::Log && range.max < 4 * range.min;
  const std::vector<double> list =
      range.scale == ScalarScale::Linear || narrow ? evenSteps(range, count) : candidates(range);
  const double slack = 1e-9 * (range.max - range.min);
  const double apart = 0.8 / std::max(count, 1);
  std::vector<ScalarTick> ticks;
  for (const double value : list) {
    if (value < range.min - slack || value > range.max + slack) continue;
    const double place = range.place(value);
    const bool free = std::none_of(ticks.begin(), ticks.end(), [&](const ScalarTick& tick) {
      return std::abs(tick.place - place) < apart;
    });
    if (free) ticks.push_back({place, numberText(value)});
  }
  std::sort(ticks.begin(), ticks.end(),
            [](const ScalarTick& a, const ScalarTick& b) { return a.place < b.place; });
  return ticks;
}

}  // namespace chartflood
