// Actions of the legend: how values become colours. Each colour mode keeps its own.

#include <cmath>
#include <cstdlib>
#include <string>

#include "app/host/actions/actions.h"
#include "app/host/actions/switch_action.h"
#include "app/host/script/action_registry.h"
#include "app/host/state/app_state.h"
#include "core/base/error.h"
#include "render/scene/color_map.h"

namespace chartflood {

namespace {

constexpr long kMostColors = 32;

std::vector<std::string> colorMapIds() {
  std::vector<std::string> ids = {"auto"};
  for (const ColorMap& map : colorMapTable()) ids.emplace_back(map.id);
  return ids;
}

std::string needsValues(const AppState& state) {
  const ColorModeInfo& info = colorModeInfo(state.view.render.colorMode);
  return *info.colorMap == '\0' ? "Choose a colour mode that shows values first." : "";
}

/// Modes with ends that mean something: those of several kinds of elements have one range a kind.
std::string needsRange(const AppState& state) {
  if (colorModeInfo(state.view.render.colorMode).domain == ValueDomain::All) {
    return "Corners, edges and faces have a range each here; choose one of them (Q).";
  }
  return needsValues(state);
}

double numberOf(const std::string& text) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != '\0' || !std::isfinite(value)) {
    throw UsageError("'" + text + "' is no number; an end of the range must be one.");
  }
  return value;
}

void setRange(AppState& state, const Arguments& a) {
  RenderSettings& render = state.view.render;
  if (a.text("low") == "auto") {
    if (a.has("high")) throw UsageError("The range is auto, or two numbers.");
    render.range.reset();
    return;
  }
  if (!a.has("high")) throw UsageError("A fixed range has two ends: give both numbers.");
  const double low = numberOf(a.text("low")), high = numberOf(a.text("high"));
  if (!(low < high)) throw UsageError("The lower end of the range must be below the upper one.");
  render.range = {low, high};
}

void setScale(AppState& state, const std::string& id) {
  std::optional<ScalarScale>& scale = state.view.render.scale;
  const ColorMap* own = findColorMap(colorModeInfo(state.view.render.colorMode).colorMap);
  if (id == "auto") {
    scale.reset();
  } else if (id == "log" && own != nullptr && own->diverging) {
    throw Refusal("These values lie on both sides of 0, where a logarithm has no place.");
  } else {
    scale = id == "log" ? ScalarScale::Log : id == "root" ? ScalarScale::Root : ScalarScale::Linear;
  }
}

const char* scaleId(const std::optional<ScalarScale>& scale) {
  if (!scale) return "auto";
  return *scale == ScalarScale::Log ? "log" : *scale == ScalarScale::Root ? "root" : "linear";
}

void addRange(ActionRegistry& registry) {
  registry.add({.id = "legend-range",
                .title = "Range of the colours",
                .help = "Auto takes it from the values, without the last 2 % of a long tail; two "
                        "numbers hold it fast.",
                .arguments = {{"low", ArgumentType::Text, "auto, or the value of the lower end"},
                              {"high", ArgumentType::Text, "the value of the upper end", false}},
                .refusal = needsRange,
                .run = setRange,
                .checked = [](const AppState& state, const Arguments& a) {
                  return (a.text("low") == "auto") != state.view.render.range.has_value();
                }});
  registry.add(
      {.id = "legend-scale",
       .title = "Scale of the colours",
       .help = "How values run along the colours; auto takes the mode's own.",
       .arguments =
           {{"kind", ArgumentType::Choice, "which one", true, {"auto", "linear", "root", "log"}}},
       .refusal = needsRange,
       .run = [](AppState& state, const Arguments& a) { setScale(state, a.text("kind")); },
       .checked =
           [](const AppState& state, const Arguments& a) {
             return a.text("kind") == scaleId(state.view.render.scale);
           }});
}

void addMap(ActionRegistry& registry) {
  registry.add({.id = "colormap",
                .title = "Colour map",
                .help = "Chooses the colours of values; auto takes the mode's own.",
                .arguments = {{"name", ArgumentType::Choice, "which one", true, colorMapIds()}},
                .refusal = {},
                .run =
                    [](AppState& state, const Arguments& a) {
                      const std::string name = a.text("name");
                      state.view.render.colorMap = name == "auto" ? "" : name;
                    },
                .checked =
                    [](const AppState& state, const Arguments& a) {
                      const std::string& map = state.view.render.colorMap;
                      return (map.empty() ? "auto" : map) == a.text("name");
                    }});
  registry.add({.id = "legend-steps",
                .title = "Steps of the colours",
                .help = "So many flat colours instead of a smooth run; 0 is smooth.",
                .arguments = {{"count", ArgumentType::Integer, "0, or 2 to 32"}},
                .refusal = needsValues,
                .run = [](AppState& state, const Arguments& a) {
                  const long count = a.integer("count");
                  if (count != 0 && (count < 2 || count > kMostColors)) {
                    throw UsageError("The colours can have 2 to 32 steps, or 0 for a smooth run.");
                  }
                  state.view.render.colorSteps = static_cast<int>(count);
                }});
  addSwitch(
      registry, "invert-colors", "Invert the colour map", "Swaps the ends of the colour map.", "",
      [](auto& state) -> auto& { return state.view.render.invertColorMap; });
  addSwitch(
      registry, "legend-clamp", "Clamp to the ends",
      "Values out of the range have its end colours; off: such faces are grey.", "",
      [](auto& state) -> auto& { return state.view.render.clampColors; });
}

}  // namespace

void addLegendActions(ActionRegistry& registry) {
  registry.add(
      {.id = "legend",
       .title = "Edit the legend\u2026",
       .help = "Range, scale and colours of the values that are shown.",
       .arguments = {{"on", ArgumentType::Switch, "left out: turns it over", false}},
       .refusal = needsValues,
       .run =
           [](AppState& state, const Arguments& a) {
             state.panels.legend = a.flag("on", !state.panels.legend);
             if (state.panels.legend) state.view.render.scalarBar = true;
           },
       .checked = [](const AppState& state, const Arguments&) { return state.panels.legend; }});
  registry.bind("Shift+B", "legend");
  addRange(registry);
  addMap(registry);
  registry.add(
      {.id = "legend-reset",
       .title = "Reset the legend",
       .help = "This mode's own range, scale and colours.",
       .arguments = {},
       .refusal = [](const AppState& state) -> std::string {
         const bool own = presentLegend(state.view.render) == LegendChoice{};
         return own ? "This legend has the mode's own range, scale and colours already." : "";
       },
       .run = [](AppState& state, const Arguments&) { setLegend(state.view.render, {}); }});
}

}  // namespace chartflood
