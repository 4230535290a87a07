// Actions about single charts, the texture they lie in, and the checkerboard on it.

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <glm/common.hpp>

#include "app/host/actions/action_needs.h"
#include "app/host/actions/actions.h"
#include "app/host/actions/chart_swap.h"
#include "app/host/actions/picture_on_charts.h"
#include "app/host/actions/switch_action.h"
#include "app/host/files/checker_picture.h"
#include "app/host/script/action_registry.h"
#include "app/host/state/app_state.h"
#include "core/base/error.h"

namespace chartflood {

namespace {

/// The chart before or after the selected one, going round.
void selectNeighbour(AppState& state, int step) {
  const auto& stats = state.results().chartStats;
  const auto count = stats ? static_cast<long>(stats->charts.size()) : 0L;
  if (count == 0) return;
  const long start = step > 0 ? -1 : 0;
  const long now = state.selectedChart == kNone ? start : static_cast<long>(state.selectedChart);
  state.selectedChart = static_cast<Index>((now + step + count) % count);
}

void hideChart(AppState& state, Index chart) {
  std::vector<Index>& hidden = state.view.hiddenCharts;
  const auto place = std::lower_bound(hidden.begin(), hidden.end(), chart);
  if (place != hidden.end() && *place == chart) return;
  hidden.insert(place, chart);
  state.view.isolate = false;
  if (state.selectedChart == chart) state.selectedChart = kNone;
  state.notices.add(Notice::Kind::Info, "Chart " + std::to_string(chart) + " is hidden.");
}

/// Brings the chart's place in the texture into view.
void showInTexture(AppState& state, Index chart) {
  const auto& atlas = state.results().atlas;
  if (!atlas || chart >= atlas->uv.size() || atlas->uv[chart].empty()) {
    throw Refusal("This chart has no place in the texture; press W to lay the charts flat.");
  }
  glm::dvec2 low(1e300), high(-1e300);
  for (const glm::dvec2& uv : atlas->uv[chart]) {
    low = glm::min(low, uv);
    high = glm::max(high, uv);
  }
  state.selectedChart = chart;
  state.panels.right = true;
  state.panels.rightTab = PanelState::RightTab::Uv;
  state.panels.selectRightTab = true;
  const double size = std::max({high.x - low.x, high.y - low.y, UvCamera::kLeastSpan});
  state.view.uvCamera = {0.5 * (low + high), 1.3 * size};
}

void addHiding(ActionRegistry& registry) {
  const ArgumentInfo which = {"chart", ArgumentType::Integer, "left out: the selected", false};
  registry.add({.id = "isolate-chart",
                .title = "Show the chart alone",
                .help = "Selects a chart and leaves the others out of both views.",
                .arguments = {which},
                .refusal = needsCharts,
                .run = [](AppState& state, const Arguments& a) {
                  state.selectedChart = namedChart(state, a);
                  state.view.isolate = true;
                }});
  registry.add(
      {.id = "hide-chart",
       .title = "Hide the chart",
       .help = "Leaves a chart out of both views, to look at what is behind it.",
       .arguments = {which},
       .refusal = needsCharts,
       .run = [](AppState& state, const Arguments& a) { hideChart(state, namedChart(state, a)); }});
  registry.bind("Shift+H", "hide-chart");
  registry.add({.id = "show-all-charts",
                .title = "Show all charts",
                .help = "Ends hiding and isolating.",
                .arguments = {},
                .refusal = [](const AppState& state) -> std::string {
                  const bool any = !state.view.hiddenCharts.empty() || state.view.isolate;
                  return any ? "" : "All charts are shown.";
                },
                .run =
                    [](AppState& state, const Arguments&) {
                      state.view.hiddenCharts.clear();
                      state.view.isolate = false;
                    }});
  registry.bind("Alt+H", "show-all-charts");
  registry.add({.id = "chart-in-texture",
                .title = "Show in texture",
                .help = "Comes close to the chart's place in the texture.",
                .arguments = {which},
                .refusal = needsCharts,
                .run = [](AppState& state, const Arguments& a) {
                  showInTexture(state, namedChart(state, a));
                }});
  registry.bind("Shift+F", "chart-in-texture");
}

void addSwap(ActionRegistry& registry) {
  registry.add({.id = "swap-colors",
                .title = "Swap colours",
                .help = "Two charts change their colours with each other; neighbours still differ.",
                .arguments = {{"chart", ArgumentType::Integer, "one chart"},
                              {"with", ArgumentType::Integer, "left out: the selected", false}},
                .refusal = needsCharts,
                .run = [](AppState& state, const Arguments& a) {
                  const Index chart = namedChart(state, a);
                  const long with = a.integer("with", static_cast<long>(state.selectedChart));
                  if (!a.has("with") && state.selectedChart == kNone) {
                    throw Refusal("Select the chart that it shall change colours with.");
                  }
                  swapColors(state, chart, with < 0 ? kNone : static_cast<Index>(with));
                }});
}

void addSelection(ActionRegistry& registry) {
  registry.add({.id = "previous-chart",
                .title = "Previous chart",
                .help = "Selects the chart before.",
                .arguments = {},
                .refusal = needsCharts,
                .run = [](AppState& state, const Arguments&) { selectNeighbour(state, -1); }});
  registry.bind("[", "previous-chart");
  registry.add({.id = "next-chart",
                .title = "Next chart",
                .help = "Selects the chart after.",
                .arguments = {},
                .refusal = needsCharts,
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
  addHiding(registry);
}

void setCheckerSize(AppState& state, double squares) {
  if (!(squares >= kFewestCheckerSquares && squares <= kMostCheckerSquares)) {
    throw UsageError("The checkerboard can have 1 to 1000 squares along the model.");
  }
  state.view.render.checkerSquares = static_cast<float>(squares);
}

void addCheckerPicture(ActionRegistry& registry) {
  registry.add({.id = "checker-picture",
                .title = "Picture on the charts",
                .help = "Shows a picture in place of the checkerboard, once across the texture. A "
                        "picture can also be dropped onto the window.",
                .arguments = {{"file", ArgumentType::Text, "PNG or JPEG"}},
                .refusal = {},
                .run = [](AppState& state, const Arguments& a) {
                  putPictureOnCharts(state, a.text("file"));
                }});
  registry.add({.id = "use-checkerboard",
                .title = "Use the checkerboard",
                .help = "Takes the picture off the charts.",
                .arguments = {},
                .refusal = [](const AppState& state) -> std::string {
                  return state.view.render.checkerPicture ? "" : "No picture lies on the charts.";
                },
                .run = [](AppState& state, const Arguments&) { dropCheckerPicture(state.view); }});
  registry.add({.id = "checker-repeats",
                .title = "Pictures across the texture",
                .help = "How often the picture goes along a side of the texture.",
                .arguments = {{"count", ArgumentType::Integer, "1 to 64"}},
                .refusal = {},
                .run = [](AppState& state, const Arguments& a) {
                  const long count = a.integer("count");
                  if (count < 1 || count > kMostCheckerRepeats) {
                    throw UsageError("The picture can go 1 to 64 times along the texture.");
                  }
                  state.view.render.checkerRepeats = static_cast<float>(count);
                }});
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
  registry.add({.id = "checker-kind",
                .title = "Checkerboard of",
                .help = "What stands on the checkerboard. Numbers show what is mirrored or turned, "
                        "circles in which direction the surface is stretched.",
                .arguments = {{"kind",
                               ArgumentType::Choice,
                               "which one",
                               true,
                               {"squares", "numbers", "circles", "picture"}}},
                .refusal = {},
                .run =
                    [](AppState& state, const Arguments& a) {
                      const CheckerKind kind = checkerKindFromId(a.text("kind"));
                      if (kind == CheckerKind::Picture && !state.view.render.checkerPicture) {
                        throw Refusal(
                            "There is no picture yet: drop a PNG or JPEG file onto the window.");
                      }
                      state.view.render.checkerKind = kind;
                    },
                .checked =
                    [](const AppState& state, const Arguments& a) {
                      return checkerKindId(state.view.render.checkerKind) == a.text("kind");
                    }});
  addCheckerPicture(registry);
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
                      tint = a.flag("on", !(tint > 0)) ? RenderSettings{}.checkerTint : 0.0f;
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
  addSwap(registry);
  addChecker(registry);
  addTexture(registry);
}

}  // namespace chartflood
