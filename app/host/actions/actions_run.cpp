// Actions that move through the rounds of a run, and what is done at its end.

#include <algorithm>

#include "app/host/actions/actions.h"
#include "app/host/script/action_registry.h"
#include "app/host/state/app_state.h"
#include "core/base/error.h"

namespace chartflood {

namespace {

std::string needsRun(const AppState& state) {
  if (!state.hasMesh()) return "There is no model yet; open one first.";
  return state.playback.rounds() == 0 ? "Nothing is flooded yet; press Play." : "";
}

std::string needsBorders(const AppState& state) {
  return state.playback.borderSteps() == 0 ? "No borders were refined yet; run to the end." : "";
}

void goToRound(AppState& state, const Arguments& a) {
  const long round = a.integer("round");
  const std::size_t rounds = state.playback.rounds();
  if (round < 1 || static_cast<std::size_t>(round) > rounds) {
    throw UsageError("There is no round " + std::to_string(round) + "; rounds are 1 to " +
                     std::to_string(rounds) + '.');
  }
  const auto all = static_cast<long>(state.playback.capacity());
  const long count = std::max(0L, a.integer("count", all));
  state.playback.goTo(static_cast<std::size_t>(round - 1), static_cast<std::size_t>(count));
}

/// The chart that is stepped by: the selected one, else the one that took the next face.
Index steppedChart(const AppState& state) {
  if (state.selectedChart != kNone) return state.selectedChart;
  const auto& record = state.playback.record();
  const std::size_t now = state.playback.playhead();
  return record && now > 0 ? (*record)[now - 1].chart : 0;
}

}  // namespace

void addRunActions(ActionRegistry& registry) {
  registry.add({.id = "go-to-round",
                .title = "Go to a round",
                .help = "Shows a round of the run at its end or after so many triangles.",
                .arguments = {{"round", ArgumentType::Integer, "its number, from 1"},
                              {"count", ArgumentType::Integer, "triangles taken", false}},
                .refusal = needsRun,
                .run = goToRound});
  registry.add({.id = "go-to-border",
                .title = "Go to a new border",
                .help = "Shows the charts as they were after so many steps of the refinement of "
                        "borders, which follows the kept round.",
                .arguments = {{"count", ArgumentType::Integer, "borders laid anew"}},
                .refusal = needsBorders,
                .run = [](AppState& state, const Arguments& a) {
                  const long count = std::max(0L, a.integer("count"));
                  state.playback.goToBorder(static_cast<std::size_t>(count));
                }});
  registry.add({.id = "run-start",
                .title = "Start of the run",
                .help = "Shows the dry model before the first round.",
                .arguments = {},
                .refusal = needsRun,
                .run = [](AppState& state, const Arguments&) { state.playback.goTo(0, 0); }});
  registry.bind("Ctrl+Home", "run-start");
  registry.add({.id = "run-end",
                .title = "End of the run",
                .help = "Shows the finished charts, or the newest of what was flooded.",
                .arguments = {},
                .refusal = needsRun,
                .run = [](AppState& state, const Arguments&) { state.playback.follow(); }});
  registry.bind("Ctrl+End", "run-end");
  registry.add({.id = "step-chart",
                .title = "Step of a chart",
                .help = "Goes to the next triangle of the selected chart, else of the one that "
                        "took the last triangle.",
                .arguments = {},
                .refusal = needsRun,
                .run = [](AppState& state, const Arguments&) {
                  if (!state.preferences.film.reducedMotion) state.flash.ask(state.playback);
                  state.request(state.playback.stepChart(steppedChart(state)));
                }});
  registry.bind("Alt+Right", "step-chart");
}

}  // namespace chartflood
