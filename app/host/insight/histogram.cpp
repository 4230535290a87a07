#include "app/host/insight/histogram.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace chartflood {

namespace {

constexpr std::size_t kBins = 48;

/// What the shares of a domain are of.
const char* shareOf(ValueDomain domain) {
  switch (domain) {
  case ValueDomain::Edge:
    return "of the creases' length";
  case ValueDomain::Vertex:
    return "of the corners";
  case ValueDomain::None:
  case ValueDomain::Triangle:
  case ValueDomain::Chart:
  case ValueDomain::Flood:
  case ValueDomain::Corner:
  case ValueDomain::All:
    break;
  }
  return "of the surface";
}

ModeHistogram histogramOf(ColorMode mode, const ModeSource& source,
                          const RenderSettings& settings) {
  ModeValues made = modeValues(mode, source);
  ModeHistogram result;
  result.range = chosenRange(std::move(made.range), settings);
  result.weight = shareOf(colorModeInfo(mode).domain);
  result.histogram = binValues(made.values, result.range, kBins);
  if (colorModeInfo(mode).domain == ValueDomain::Flood) {
    // Shares are of the whole surface, so that bars stay where they are while more of it is taken.
    for (double& share : result.histogram.share) share *= 1 - result.histogram.missing;
  }
  return result;
}

}  // namespace

Histogram binValues(std::span<const WeightedValue> values, const ScalarRange& range,
                    std::size_t bins) {
  Histogram result;
  result.share.assign(bins, 0.0);
  double total = 0, missing = 0;
  for (const WeightedValue& v : values) {
    if (!(v.weight > 0)) continue;
    if (!std::isfinite(v.value)) {
      missing += v.weight;
      continue;
    }
    total += v.weight;
    if (v.value < range.min) result.below += v.weight;
    if (v.value > range.max) result.above += v.weight;
    const auto bin = static_cast<std::size_t>(range.place(v.value) * static_cast<double>(bins));
    result.share[std::min(bin, bins - 1)] += v.weight;
  }
  if (total > 0) {
    for (double& share : result.share) share /= total;
    result.below /= total;
    result.above /= total;
  }
  if (total + missing > 0) result.missing = missing / (total + missing);
  return result;
}

double valueAt(const ScalarRange& range, double place) {
  if (range.scale == ScalarScale::Log) return range.min * std::pow(range.max / range.min, place);
  const double t = range.scale == ScalarScale::Root ? place * place : place;
  return range.min + t * (range.max - range.min);
}

std::vector<ModeHistogram> modeHistograms(const ModeSource& source,
                                          const RenderSettings& settings) {
  const ColorMode mode = settings.colorMode;
  if (!canShow(mode, source)) return {};
  if (colorModeInfo(mode).domain != ValueDomain::All) {
    if (colorModeInfo(mode).values == nullptr) return {};
    return {histogramOf(mode, source, settings)};
  }
  RenderSettings own = settings;
  own.range.reset();  // each kind is drawn on its own
  std::vector<ModeHistogram> result;
  for (const ValueDomain element :
       {ValueDomain::Triangle, ValueDomain::Edge, ValueDomain::Vertex}) {
    result.push_back(histogramOf(modeOfElement(mode, element), source, own));
  }
  return result;
}

}  // namespace chartflood
