#include "app/host/files/session_legend.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <sstream>
#include <utility>

#include "render/scene/color_map.h"

namespace chartflood {

namespace {

constexpr const char* kScales[] = {"linear", "root", "log"};

/// What differs from a mode's own legend, as words with a space before each.
std::string legendText(const LegendChoice& legend) {
  std::ostringstream text;
  text.precision(17);
  if (!legend.colorMap.empty()) text << " colormap=" << legend.colorMap;
  if (legend.range) text << " range=" << legend.range->first << ',' << legend.range->second;
  if (legend.scale) text << " scale=" << kScales[static_cast<std::size_t>(*legend.scale)];
  if (legend.steps != 0) text << " steps=" << legend.steps;
  if (legend.invert) text << " invert";
  if (!legend.clamp) text << " no-clamp";
  return text.str();
}

/// Takes in one word of legendText(); false for one that is not known.
bool setLegendWord(LegendChoice& legend, const std::string& word) {
  const std::size_t equals = std::min(word.find('='), word.size());
  const std::string key = word.substr(0, equals);
  const std::string value = equals == word.size() ? "" : word.substr(equals + 1);
  if (key == "invert") return legend.invert = true;
  if (key == "no-clamp") return !(legend.clamp = false);
  if (key == "colormap") {
    legend.colorMap = value;
    return findColorMap(value) != nullptr;
  }
  if (key == "steps") {
    legend.steps = std::atoi(value.c_str());
    return legend.steps >= 2 && legend.steps <= 32;
  }
  if (key == "scale") {
    const auto* known = std::find(std::begin(kScales), std::end(kScales), value);
    if (known == std::end(kScales)) return false;
    legend.scale = static_cast<ScalarScale>(known - std::begin(kScales));
    return true;
  }
  char comma = 0;
  std::pair<double, double> range;
  std::istringstream ends(value);
  if (key != "range" || !(ends >> range.first >> comma >> range.second) || comma != ',') {
    return false;
  }
  legend.range = range;
  return std::isfinite(range.first) && std::isfinite(range.second) && range.first < range.second;
}

}  // namespace

std::string legendsText(const ViewSettings& view) {
  std::map<ColorMode, LegendChoice> all = view.legends;
  all[view.render.colorMode] = presentLegend(view.render);
  std::string text;
  for (const auto& [mode, legend] : all) {
    if (legend == LegendChoice{}) continue;
    text += (text.empty() ? "" : "; ") + std::string(colorModeInfo(mode).id) + legendText(legend);
  }
  return text;
}

bool applyLegends(const std::string& text, ViewSettings& view) {
  std::map<ColorMode, LegendChoice> legends;
  std::istringstream parts(text);
  for (std::string part; std::getline(parts, part, ';');) {
    std::istringstream words(part);
    std::string word;
    if (!(words >> word)) continue;
    const ColorModeInfo* mode = findColorMode(word);
    if (mode == nullptr) return false;
    while (words >> word) {
      if (!setLegendWord(legends[mode->mode], word)) return false;
    }
  }
  if (const auto present = legends.find(view.render.colorMode); present != legends.end()) {
    setLegend(view.render, present->second);
    legends.erase(present);
  }
  view.legends = std::move(legends);
  return true;
}

}  // namespace chartflood
