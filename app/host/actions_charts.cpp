// Actions about single charts, the texture they lie in, and the checkerboard on it.

#include <algorithm>
#include <cmath>

#include "app/host/action_registry.h"
#include "app/host/actions.h"
#include "app/host/app_state.h"
#include "app/host/switch_action.h"
#include "core/base/error.h"

namespace chartflood {

namespace {

constexpr double kFewestSquares = 1, kMostSquares = 1000;
constexpr float kTint = RenderSettings{}.checkerTint;

/// The chart before or after the selected one, going round.
void selectNeighbour(AppState& state, int step) {
  const auto& stats = state.results().chartStats;
  const auto count = stats ? static_cast<long>(stats->charts.size()) : 0L;
  if (count == 0) return;
  const long start = step > 0 ? -1 : 0;
  const long now = state.selectedChart == kNone ? start : static_cast<long>(state.selectedChart);
  state.selectedChart = static_cast<Index>((now + step + count) % count);
}

void addSelection(ActionRegistry& registry) {
  auto refusal = [](const AppState& state) -> std::string {
    const auto& stats = state.results().chartStats;
    return stats && !stats->charts.empty() ? "" : "There are no charts yet.";
  };
  registry.add({.id = "previous-chart",
                .title = "Previous chart",
                .help = "Selects the chart before.",
                .arguments = {},
                .refusal = refusal,
                .run = [](AppState& state, const Arguments&) { selectNeighbour(state, -1); }});
  registry.bind("[", "previous-chart");
  registry.add({.id = "next-chart",
                .title = "Next chart",
                .help = "Selects the chart after.",
                .arguments = {},
                .refusal = refusal,
                .run = [](AppState& state, const Arguments&) { selectNeighbour(state, 1); }});
  registry.bind("]", "next-chart");
  registry.add({.id = "select-chart",
                .title = "Select a chart",
                .help = "Marks a chart; left out: none.",
                .arguments = {{"chart", ArgumentType::Integer, "its number", false}},
                .refusal = {},
                .run = [](AppState& state, const Arguments& a) {
                  const long chart = a.integer("chart", -1);
                  const Index wanted = chart < 0 ? kNone : static_cast<Index>(chart);
                  state.selectedChart = wanted == state.selectedChart ? kNone : wanted;
                }});
  registry.add(
      {.id = "isolate",
       .title = "Isolate the chart",
       .help = "Shows the selected chart alone, in both views; once more shows all.",
       .arguments = {{"on", ArgumentType::Switch, "left out: turns it over", false}},
       .refusal = [](const AppState& state) -> std::string {
         const bool can = state.view.isolate || state.selectedChart != kNone;
         return can ? "" : "Select a chart first.";
       },
       .run = [](AppState& state,
                 const Arguments& a) { state.view.isolate = a.flag("on", !state.view.isolate); },
       .checked = [](const AppState& state, const Arguments&) { return state.view.isolate; }});
  registry.bind("I", "isolate");
}

void setCheckerSize(AppState& state, double squares) {
  if (!(squares >= kFewestSquares && squares <= kMostSquares)) {
    throw UsageError("The checkerboard can have 1 to 1000 squares along the model.");
  }
  state.view.render.checkerSquares = static_cast<float>(squares);
}

void addChecker(ActionRegistry& registry) {
  registry.add({.id = "checker-size",
                .title = "Squares",
                .help = "How many squares of the checkerboard go along the model's diagonal, or "
                        "along the texture.",
                .arguments = {{"squares", ArgumentType::Number, "1 to 1000"}},
                .refusal = {},
                .run = [](AppState& state, const Arguments& a) {
                  setCheckerSize(state, a.number("squares"));
                }});
  registry.add(
      {.id = "checker-kind",
       .title = "Checkerboard of",
       .help = "What stands on the checkerboard. Numbers show what is mirrored or turned, "
               "circles in which direction the surface is stretched.",
       .arguments =
           {{"kind", ArgumentType::Choice, "which one", true, {"squares", "numbers", "circles"}}},
       .refusal = {},
       .run =
           [](AppState& state, const Arguments& a) {
             state.view.render.checkerKind = checkerKindFromId(a.text("kind"));
           },
       .checked =
           [](const AppState& state, const Arguments& a) {
             return checkerKindId(state.view.render.checkerKind) == a.text("kind");
           }});
  addSwitch(
      registry, "checker-in-texture", "By the texture",
      "Squares of one size in the texture; off: of one size on the model.", "",
      [](auto& state) -> auto& { return state.view.render.checkerInTexture; });
  registry.add({.id = "checker-tint",
                .title = "Tint by chart",
                .help = "The checkerboard leans towards the colour of each chart.",
                .arguments = {{"on", ArgumentType::Switch, "left out: turns it over", false}},
                .refusal = {},
                .run =
                    [](AppState& state, const Arguments& a) {
                      float& tint = state.view.render.checkerTint;
                      tint = a.flag("on", !(tint > 0)) ? kTint : 0.0f;
                    },
                .checked = [](const AppState& state,
                              const Arguments&) { return state.view.render.checkerTint > 0; }});
}

void addTexture(ActionRegistry& registry) {
  addSwitch(
      registry, "uv-fill", "Fill the texture", "Charts in colour; off: their outlines alone.", "",
      [](auto& state) -> auto& { return state.view.uv.fill; });
  addSwitch(
      registry, "uv-frame", "Texture grid", "The border of the texture with numbers and a grid.",
      "", [](auto& state) -> auto& { return state.view.uv.frame; });
  registry.add({.id = "frame-uv",
                .title = "Frame the texture",
                .help = "Shows the whole texture.",
                .arguments = {},
                .refusal = {},
                .run = [](AppState& state, const Arguments&) { state.view.uvCamera = {}; }});
}

}  // namespace

void addChartActions(ActionRegistry& registry) {
  addSelection(registry);
  addChecker(registry);
  addTexture(registry);
}

}  // namespace chartflood
