// Actions of the flood: playing, stepping, running, starting over.

#include <algorithm>

#include "app/host/actions/action_needs.h"
#include "app/host/actions/actions.h"
#include "app/host/script/action_registry.h"
#include "app/host/state/app_state.h"
#include "core/base/error.h"

namespace chartflood {

namespace {

std::string needsRecord(const AppState& state) {
  if (!state.hasMesh()) return needsMesh(state);
  return state.playback.recorded() == 0 ? "Nothing is flooded yet; press Play." : "";
}

std::string needsMoreToFlood(const AppState& state) {
  if (!state.hasMesh()) return needsMesh(state);
  const bool over =
      state.results().finished && state.playback.atEndOfRun() && state.playback.complete();
  return over ? "The segmentation is finished; reset it or change a parameter to go on." : "";
}

/// Charts of the present values can always be gone to where values are answered with them.
std::string needsMoreToRun(const AppState& state) {
  const bool again = state.results().unsettled || state.preferences.explore;
  return state.hasMesh() && again ? "" : needsMoreToFlood(state);
}

std::string needsRounds(const AppState& state) {
  if (!state.hasMesh()) return needsMesh(state);
  return state.results().history.empty() ? "No round is finished yet." : "";
}

std::size_t manySteps(const AppState& state) {
  return manyFacesCount(state.preferences.film.many, state.playback.capacity(),
                        state.results().start.seeds.size());
}

void addStep(ActionRegistry& registry) {
  registry.add({.id = "step",
                .title = "Step",
                .help = "Takes the next triangle.",
                .arguments = {{"count", ArgumentType::Integer, "how many triangles", false}},
                .refusal = needsMoreToFlood,
                .run = [](AppState& state, const Arguments& a) {
                  const long count = a.integer("count", 1);
                  if (count < 1) throw UsageError("A step takes at least 1 triangle.");
                  if (!state.preferences.film.reducedMotion) state.flash.ask(state.playback);
                  state.request(state.playback.stepForward(static_cast<std::size_t>(count)));
                }});
  registry.bind("Right", "step");
  registry.add({.id = "step-many",
                .title = "Step many",
                .help = "Takes many triangles: a hundredth of all, or as chosen.",
                .arguments = {},
                .refusal = needsMoreToFlood,
                .run = [](AppState& state, const Arguments&) {
                  state.request(state.playback.stepForward(manySteps(state)));
                }});
  registry.bind("Shift+Right", "step-many");
  registry.add({.id = "back",
                .title = "Back",
                .help = "Gives the last triangle back; nothing is computed again.",
                .arguments = {{"count", ArgumentType::Integer, "how many triangles", false}},
                .refusal = needsRecord,
                .run = [](AppState& state, const Arguments& a) {
                  const long count = a.integer("count", 1);
                  if (count < 1) throw UsageError("A step back gives at least 1 triangle back.");
                  state.playback.stepBack(static_cast<std::size_t>(count));
                }});
  registry.bind("Left", "back");
  registry.add({.id = "back-many",
                .title = "Back many",
                .help = "Gives many triangles back: a hundredth of all, or as chosen.",
                .arguments = {},
                .refusal = needsRecord,
                .run = [](AppState& state, const Arguments&) {
                  state.playback.stepBack(manySteps(state));
                }});
  registry.bind("Shift+Left", "back-many");
}

void addTransport(ActionRegistry& registry) {
  registry.add({.id = "play",
                .title = "Play",
                .help = "Floods at the chosen speed, round after round; once more pauses.",
                .arguments = {},
                .refusal = needsMesh,
                .run =
                    [](AppState& state, const Arguments&) {
                      state.playback.playing() ? state.playback.pause() : state.playback.play();
                    },
                .checked = [](const AppState& state,
                              const Arguments&) { return state.playback.playing(); }});
  registry.bind("Space", "play");
  addStep(registry);
  registry.add({.id = "finish",
                .title = "Finish this flood",
                .help = "Goes to the end of the round shown, or of the refinement of borders.",
                .arguments = {},
                .refusal = needsMoreToFlood,
                .run = [](AppState& state, const Arguments&) {
                  if (state.playback.showsBorders()) return state.playback.follow();
                  if (state.playback.complete()) {
                    return state.playback.seek(state.playback.capacity());
                  }
                  state.playback.follow();
                  state.request(StepRequest{StepUnit::Flood, 1});
                }});
  registry.bind("Ctrl+Right", "finish");
  registry.add({.id = "seek",
                .title = "Go to a moment",
                .help = "Shows the flood as it was after so many triangles.",
                .arguments = {{"count", ArgumentType::Integer, "triangles taken"}},
                .refusal = needsRecord,
                .run = [](AppState& state, const Arguments& a) {
                  state.playback.seek(static_cast<std::size_t>(std::max(0L, a.integer("count"))));
                }});
  registry.add({.id = "first",
                .title = "First step",
                .help = "Shows the start of the round shown, or of the refinement of borders.",
                .arguments = {},
                .refusal = needsRecord,
                .run = [](AppState& state, const Arguments&) {
                  state.playback.showsBorders() ? state.playback.goToBorder(0)
                                                : state.playback.seek(0);
                }});
  registry.bind("Home", "first");
  registry.add({.id = "last",
                .title = "Last step",
                .help = "Shows the end of the round shown, as far as it was flooded.",
                .arguments = {},
                .refusal = needsRecord,
                .run = [](AppState& state, const Arguments&) {
                  if (state.playback.showsBorders()) return state.playback.follow();
                  state.playback.seek(state.playback.capacity());
                }});
  registry.bind("End", "last");
}

void setSpeed(AppState& state, const std::string& text) {
  if (text == "auto") return state.playback.setSpeed(0);
  if (text == "max") return state.playback.setSpeed(2 * Playback::kFastest);
  char* end = nullptr;
  const double speed = std::strtod(text.c_str(), &end);
  if (*end != '\0' || !(speed >= Playback::kSlowest && speed <= Playback::kFastest)) {
    throw UsageError("The speed '" + text +
                     "' must be auto, max or 1 to 1000000 triangles per second.");
  }
  state.playback.setSpeed(speed);
}

void stop(AppState& state) {
  if (state.pictureRow.running()) {
    state.requests.stopPictures = true;
    return;
  }
  const bool resting =
      !state.status().busy && !state.playback.playing() && !state.methodRuns.running();
  const bool inFilm = state.playback.hasFinal() && !state.playback.atFinal();
  if (resting && inFilm && state.preferences.explore) return state.playback.follow();
  if (resting) state.selectedChart = state.chosenSeed = kNone;
  state.playback.pause();
  state.session().stop();
  if (!state.methodRuns.running()) return;
  state.methodRuns.stop();
  state.notices.add(Notice::Kind::Info, "The comparison of methods was given up.");
}

void addRuns(ActionRegistry& registry) {
  registry.add(
      {.id = "iteration",
       .title = "One round",
       .help = "Finishes the flood, moves each seed to its chart's middle and floods again.",
       .arguments = {},
       .refusal = needsMoreToFlood,
       .run = [](AppState& state, const Arguments&) {
         state.playback.follow();
         state.request(StepRequest{StepUnit::Iteration, 1});
       }});
  registry.bind("L", "iteration");
  registry.add({.id = "run",
                .title = "Run to the end",
                .help = "Floods round after round without waiting, until a stop rule fires, and "
                        "shows the finished charts.",
                .arguments = {},
                .refusal = needsMoreToRun,
                .run = [](AppState& state, const Arguments&) { state.finish(); }});
  registry.bind("Enter", "run");
  registry.add({.id = "stop",
                .title = "Stop",
                .help =
                    "Stops at the next triangle; what was done so far stays. Then leads from the "
                    "film to the finished charts, then deselects.",
                .arguments = {},
                .refusal = {},
                .run = [](AppState& state, const Arguments&) { stop(state); }});
  registry.bind("Esc", "stop");
  registry.add(
      {.id = "speed",
       .title = "Speed",
       .help = "Sets how many triangles are played per second.",
       .arguments = {{"triangles", ArgumentType::Text, "a number, auto or max"}},
       .refusal = {},
       .run = [](AppState& state, const Arguments& a) { setSpeed(state, a.text("triangles")); }});
}

void addUnwrap(ActionRegistry& registry) {
  registry.add({.id = "unwrap",
                .title = "Unwrap",
                .help = "Cuts the charts into disks, lays them flat and packs them into a texture.",
                .arguments = {},
                .refusal = [](const AppState& state) -> std::string {
                  if (!state.hasMesh()) return needsMesh(state);
                  const auto& labels = state.results().segmentation;
                  const bool ready = labels && labels->complete && !state.results().stale;
                  return ready ? "" : "There are no complete charts yet; finish a flood first.";
                },
                .run = [](AppState& state, const Arguments&) { state.session().unwrap(); }});
  registry.bind("W", "unwrap");
}

void addResets(ActionRegistry& registry) {
  registry.add({.id = "reset-flood",
                .title = "Reset flood",
                .help = "A dry model with the same seeds.",
                .arguments = {},
                .refusal = needsMesh,
                .run = [](AppState& state, const Arguments&) {
                  state.playback.follow();
                  state.rememberCharts("Reset flood");
                  state.session().resetFlood();
                }});
  registry.bind("R", "reset-flood");
  registry.add({.id = "reset-seeds",
                .title = "Reset seeds",
                .help = "Begins again with the first seeds.",
                .arguments = {},
                .refusal = needsMesh,
                .run = [](AppState& state, const Arguments&) {
                  state.playback.follow();
                  state.rememberCharts("Reset seeds");
                  state.session().resetSeeds();
                }});
  registry.bind("Shift+R", "reset-seeds");
  registry.add({.id = "adopt",
                .title = "Use a round",
                .help = "Takes the charts of a finished round and goes on from there.",
                .arguments = {{"round", ArgumentType::Integer, "its number, from 1"}},
                .refusal = needsRounds,
                .run = [](AppState& state, const Arguments& a) {
                  const long round = a.integer("round");
                  const std::size_t rounds = state.results().history.size();
                  if (round < 1 || static_cast<std::size_t>(round) > rounds) {
                    throw UsageError("There is no round " + std::to_string(round) +
                                     "; finished rounds are 1 to " + std::to_string(rounds) + '.');
                  }
                  state.playback.follow();
                  state.rememberCharts("Use round " + std::to_string(round));
                  state.session().adoptIteration(static_cast<std::size_t>(round - 1));
                }});
  registry.add({.id = "best",
                .title = "Use the best round",
                .help = "Takes the charts of the best balanced round so far.",
                .arguments = {},
                .refusal = needsRounds,
                .run = [](AppState& state, const Arguments&) {
                  state.playback.follow();
                  state.rememberCharts("Use the best round");
                  state.session().adoptIteration(state.results().bestIteration);
                }});
  registry.bind("Shift+L", "best");
}

}  // namespace

void addSegmentActions(ActionRegistry& registry) {
  addTransport(registry);
  addRuns(registry);
  addUnwrap(registry);
  addResets(registry);
}

}  // namespace chartflood
