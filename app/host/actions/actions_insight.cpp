// Actions about seeing why: the Gauss sphere, plots, figures of charts, what deserves attention.

#include <algorithm>
#include <string>

#include "app/host/actions/action_needs.h"
#include "app/host/actions/actions.h"
#include "app/host/actions/switch_action.h"
#include "app/host/insight/chart_csv.h"
#include "app/host/script/action_registry.h"
#include "app/host/state/app_state.h"
#include "core/base/error.h"

namespace chartflood {

namespace {

void addFigures(ActionRegistry& registry) {
  registry.add({.id = "copy-charts",
                .title = "Copy as CSV",
                .help = "Copies all figures of all charts as a table for other programs.",
                .arguments = {},
                .refusal = needsCharts,
                .run = [](AppState& state, const Arguments&) {
                  state.requests.clipboard = chartsCsv(state.results());
                  state.notices.add(Notice::Kind::Info, "Copied the figures of all charts.");
                }});
  registry.add({.id = "copy-figures",
                .title = "Copy figures",
                .help = "Copies all figures of one chart as text.",
                .arguments = {{"chart", ArgumentType::Integer, "left out: the selected", false}},
                .refusal = needsCharts,
                .run = [](AppState& state, const Arguments& a) {
                  const Index chart = namedChart(state, a);
                  state.requests.clipboard = chartFigures(state.results(), chart);
                  state.notices.add(Notice::Kind::Info,
                                    "Copied the figures of chart " + std::to_string(chart) + ".");
                }});
  addSwitch(
      registry, "bars-by-value", "Largest first", "Bars of charts stand by size; off: by number.",
      "", [](auto& state) -> auto& { return state.panels.barsByValue; });
}

void addSphere(ActionRegistry& registry) {
  registry.add(
      {.id = "sphere-linked",
       .title = "Turn with the model",
       .help = "The Gauss sphere is seen from where the model is seen; off: it turns by its own.",
       .arguments = {{"on", ArgumentType::Switch, "left out: turns it over", false}},
       .refusal = {},
       .run =
           [](AppState& state, const Arguments& a) {
             ViewSettings& view = state.view;
             const bool on = a.flag("on", !view.sphereLinked);
             // It goes on from where it is.
             if (view.sphereLinked && !on) view.sphereCamera = view.camera;
             view.sphereLinked = on;
           },
       .checked = [](const AppState& state, const Arguments&) { return state.view.sphereLinked; }});
}

/// Frames the chart given or selected, else the whole of what the mouse is on.
void frameSelection(AppState& state, const Arguments& a) {
  if (a.has("chart")) {
    if (const std::string reason = needsCharts(state); !reason.empty()) throw Error(reason);
    return state.showChart(namedChart(state, a));
  }
  if (state.panels.uvUnderMouse) {
    state.view.uvCamera = {};
  } else if (state.selectedChart != kNone) {
    state.showChart(state.selectedChart);
  } else {
    state.view.frameWhenLoaded = true;
  }
}

/// The place after the one that is selected now, going round; the first when none is.
const ProblemPlace& nextPlace(const AppState& state, const Problem& problem) {
  const auto& places = problem.places;
  const auto now = std::find_if(places.begin(), places.end(), [&](const ProblemPlace& place) {
    return place.face != kNone ? place.face == state.panels.shownFace
                               : place.chart == state.selectedChart;
  });
  return now == places.end() || now + 1 == places.end() ? places.front() : *(now + 1);
}

void showProblem(AppState& state, const std::string& id) {
  const auto problems = state.insight().problems(state.results());
  if (!problems) throw Error("There are no charts yet.");
  const auto found = std::find_if(problems->begin(), problems->end(), [&](const Problem& problem) {
    return id == problemId(problem.kind);
  });
  if (found == problems->end()) throw Error("There is nothing of this kind.");
  const ProblemPlace place = nextPlace(state, *found);
  state.panels.shownFace = place.face;
  if (place.face != kNone) return state.showFace(place.face);
  state.showChart(place.chart);
}

/// Unfolds the list of problems and brings it to the front, or folds it.
void unfoldProblems(AppState& state, bool unfold) {
  PanelState& p = state.panels;
  p.problems = unfold;
  if (!unfold) return;
  p.right = true;
  p.rightTab = PanelState::RightTab::Charts;
  p.selectRightTab = true;
}

void addProblems(ActionRegistry& registry) {
  registry.add({.id = "problems",
                .title = "Problems",
                .help = "Marks what deserves attention on the model and in the texture, and lists "
                        "it in the tab of the charts.",
                .arguments = {{"on", ArgumentType::Switch, "left out: turns it over", false}},
                .refusal = {},
                .run =
                    [](AppState& state, const Arguments& a) {
                      bool& marks = state.view.render.problems;
                      marks = a.flag("on", !marks);
                      unfoldProblems(state, marks);
                    },
                .checked = [](const AppState& state,
                              const Arguments&) { return state.view.render.problems; }});
  registry.bind("P", "problems");
  registry.add(
      {.id = "problem-list",
       .title = "Worth a look",
       .help = "Lists what deserves attention, in the tab of the charts.",
       .arguments = {{"on", ArgumentType::Switch, "left out: turns it over", false}},
       .refusal = {},
       .run =
           [](AppState& state, const Arguments& a) {
             unfoldProblems(state, a.flag("on", !state.panels.problems));
           },
       .checked = [](const AppState& state, const Arguments&) { return state.panels.problems; }});
  std::vector<std::string> kinds;
  for (const ProblemKind kind : problemKinds()) kinds.emplace_back(problemId(kind));
  registry.add(
      {.id = "show-problem",
       .title = "Show",
       .help = "Selects and frames the next place of this kind.",
       .arguments = {{"kind", ArgumentType::Choice, "of what", true, kinds}},
       .refusal = needsCharts,
       .run = [](AppState& state, const Arguments& a) { showProblem(state, a.text("kind")); }});
}

void addTabs(ActionRegistry& registry) {
  registry.add({.id = "next-tab",
                .title = "Next tab",
                .help = "Goes round the tabs of the right pane.",
                .arguments = {},
                .refusal = {},
                .run = [](AppState& state, const Arguments&) {
                  using Tab = PanelState::RightTab;
                  PanelState& p = state.panels;
                  if (p.right) {
                    p.rightTab = p.rightTab == Tab::Plots
                                     ? Tab::Uv
                                     : static_cast<Tab>(static_cast<int>(p.rightTab) + 1);
                  }
                  p.right = true;
                  p.selectRightTab = true;
                }});
  registry.bind("Shift+U", "next-tab");
}

}  // namespace

void addInsightActions(ActionRegistry& registry) {
  addFigures(registry);
  addSphere(registry);
  registry.add({.id = "frame-selection",
                .title = "Zoom to chart",
                .help = "Comes close to the selected chart; shows all where none is selected.",
                .arguments = {{"chart", ArgumentType::Integer, "left out: the selected", false}},
                .refusal = {},
                .run = frameSelection});
  registry.bind("F", "frame-selection");
  addProblems(registry);
  addTabs(registry);
}

}  // namespace chartflood
