#include "render/scene/mode_values.h"

#include <algorithm>
#include <cmath>

namespace chartflood {

namespace {

/// Both ends as far from 0 as the tail of the values: shares of the surface.
ScalarRange aroundZero(std::span<const WeightedValue> values) {
  std::vector<WeightedValue> sizes(values.begin(), values.end());
  for (WeightedValue& each : sizes) each.value = std::abs(each.value);
  ScalarRange range;
  range.max = std::max(std::ceil(weightedPercentile(sizes, 0.98) * 2) / 2, 0.5);
  range.min = -range.max;
  return range;
}

ScalarRange fromOne(std::span<const WeightedValue> values) {
  ScalarRange range;
  range.min = 1;
  // Never less than 1.1, or the noise of a good unwrap would look like a bad one.
  range.max = std::max(std::ceil(weightedPercentile(values, 0.98) * 20) / 20, 1.1);
  range.hasMean = true;
  range.mean = weightedMean(values);
  return range;
}

ScalarRange aroundMean(std::span<const WeightedValue> values) {
  double largest = 0;
  for (const WeightedValue& each : values) largest = std::max(largest, std::abs(each.value));
  ScalarRange range;
  // Never less than 10 %: a good balance shall look white.
  range.max = std::clamp(std::ceil(largest / 10) * 10, 10.0, 100.0);
  range.min = -range.max;
  return range;
}

ScalarRange ruleRange(RangeRule rule, std::span<const WeightedValue> values) {
  switch (rule) {
  case RangeRule::Shares:
    break;
  case RangeRule::FromZero:
    return rangeFromZero(values);
  case RangeRule::FromOne:
    return fromOne(values);
  case RangeRule::AroundZero:
    return aroundZero(values);
  case RangeRule::AroundMean:
    return aroundMean(values);
  case RangeRule::PlainEnds: {
    ScalarRange range;
    range.plainEnds = true;
    return range;
  }
  }
  return {};
}

}  // namespace

bool canShow(ColorMode mode, const ModeSource& source) {
  if (!source.mesh) return false;
  const bool flooded = source.record && source.taken > 0;
  switch (colorModeInfo(mode).needs) {
  case ModeNeed::Nothing:
    return true;
  case ModeNeed::Charts:
    return source.segmentation || source.stats || flooded;
  case ModeNeed::GaussArea:
    return source.gauss != nullptr;
  case ModeNeed::Flood:
    return flooded;
  case ModeNeed::Unwrap:
    return source.unwrap && source.unwrap->stretch.size() == source.mesh->triangleCount();
  case ModeNeed::Texture:
    return source.layout && !source.layout->empty();
  }
  return false;
}

ModeSource neededBy(ColorMode mode, const ModeSource& source) {
  ModeSource needed;
  needed.mesh = source.mesh;
  switch (colorModeInfo(mode).needs) {
  case ModeNeed::Nothing:
    break;
  case ModeNeed::Charts:
    needed.segmentation = source.segmentation;
    needed.stats = source.stats;
    break;
  case ModeNeed::GaussArea:
    needed.gauss = source.gauss;
    break;
  case ModeNeed::Flood:
    needed.record = source.record;
    needed.recorded = source.recorded;
    needed.taken = source.taken;
    break;
  case ModeNeed::Unwrap:
    needed.unwrap = source.unwrap;
    break;
  case ModeNeed::Texture:
    needed.layout = source.layout;
    break;
  }
  return needed;
}

ModeValues modeValues(ColorMode mode, const ModeSource& source) {
  const ColorModeInfo& info = colorModeInfo(mode);
  if (info.values == nullptr || !canShow(mode, source)) return {{}, modeRange(mode, {})};
  return info.values(info, source);
}

ScalarRange modeRange(ColorMode mode, std::span<const WeightedValue> values) {
  const ColorModeInfo& info = colorModeInfo(mode);
  ScalarRange range = ruleRange(info.range, values);
  range.title = info.title;
  range.unit = info.unit;
  range.scale = info.scale;
  return range;
}

ColorMode modeOfElement(ColorMode mode, ValueDomain element) {
  const ColorModeInfo& info = colorModeInfo(mode);
  if (info.domain != ValueDomain::All) return mode;
  for (const ColorMode other : colorModeFamily(mode)) {
    if (colorModeInfo(other).domain == element) return other;
  }
  return mode;
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
