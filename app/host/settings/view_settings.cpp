#include "app/host/settings/view_settings.h"

#include <algorithm>
#include <array>

namespace chartflood {

namespace {

constexpr std::array kModes = {
    ColorMode::Shaded,      ColorMode::Charts,         ColorMode::Gauss,
    ColorMode::GaussVertex, ColorMode::GaussEdge,      ColorMode::GaussFace,
    ColorMode::Balance,     ColorMode::FloodTime,      ColorMode::FloodOrder,
    ColorMode::Stretch,     ColorMode::AreaDistortion, ColorMode::AngleDistortion,
    ColorMode::Checkerboard};

constexpr std::array kGauss = {ColorMode::Gauss, ColorMode::GaussVertex, ColorMode::GaussEdge,
                               ColorMode::GaussFace};
constexpr std::array kFlood = {ColorMode::FloodTime, ColorMode::FloodOrder};

}  // namespace

LegendChoice presentLegend(const RenderSettings& render) {
  return {render.colorMap,    render.invertColorMap, render.colorSteps,
          render.clampColors, render.scale,          render.range};
}

void setLegend(RenderSettings& render, const LegendChoice& choice) {
  render.colorMap = choice.colorMap;
  render.invertColorMap = choice.invert;
  render.colorSteps = choice.steps;
  render.clampColors = choice.clamp;
  render.scale = choice.scale;
  render.range = choice.range;
}

void showColorMode(ViewSettings& view, ColorMode mode) {
  RenderSettings& render = view.render;
  if (mode == render.colorMode) return;
  if (const LegendChoice own = presentLegend(render); own != LegendChoice{}) {
    view.legends[render.colorMode] = own;
  }
  const auto kept = view.legends.find(mode);
  setLegend(render, kept == view.legends.end() ? LegendChoice{} : kept->second);
  if (kept != view.legends.end()) view.legends.erase(kept);
  render.colorMode = mode;
}

std::span<const ColorMode> availableColorModes() { return kModes; }

std::span<const ColorMode> colorModeFamily(ColorMode mode) {
  if (std::find(kGauss.begin(), kGauss.end(), mode) != kGauss.end()) return kGauss;
  if (std::find(kFlood.begin(), kFlood.end(), mode) != kFlood.end()) return kFlood;
  const auto single = std::find(kModes.begin(), kModes.end(), mode);
  if (single == kModes.end()) return {};
  return {&*single, 1};
}

}  // namespace chartflood
