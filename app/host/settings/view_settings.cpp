#include "app/host/settings/view_settings.h"

namespace chartflood {

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

}  // namespace chartflood
