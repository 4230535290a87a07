// Seeds by keyboard alone: one is chosen, the arrow keys move it over the surface.

#include <algorithm>
#include <string>

#include <glm/geometric.hpp>

#include "app/host/actions/action_needs.h"
#include "app/host/actions/actions.h"
#include "app/host/actions/seed_edits.h"
#include "app/host/film/seed_steps.h"
#include "app/host/script/action_registry.h"
#include "app/host/state/app_state.h"

namespace chartflood {

namespace {

constexpr long kMostFaces = 1000;

bool hasChosen(const AppState& state) { return state.chosenSeed < state.presentSeeds().size(); }

/// Turns the model so that a face looks at the eye, where it looks away.
void turnTowards(AppState& state, Index face) {
  const glm::dvec3 normal = faceNormal(*state.results().mesh, face);
  Camera& camera = state.view.camera;
  if (!(glm::length(normal) > 0) || glm::dot(normal, camera.forward()) < 0) return;
  const glm::dvec3 up = camera.up == UpAxis::Z ? glm::dvec3(0, 0, 1) : glm::dvec3(0, 1, 0);
  camera.lookAlong(-glm::normalize(normal), up);
}

void chooseSeed(AppState& state, const std::string& which) {
  if (which == "none") {
    state.chosenSeed = kNone;
    return;
  }
  const std::vector<PlacedSeed> seeds = state.presentSeeds();
  const auto count = static_cast<long>(seeds.size());
  const long step = which == "next" ? 1 : -1;
  const long start = step > 0 ? -1 : 0;
  const long now = hasChosen(state) ? static_cast<long>(state.chosenSeed) : start;
  state.chosenSeed = static_cast<Index>((now + step + count) % count);
  state.panels.tool = PanelState::Tool::Seeds;
  state.view.render.seedMarks = true;
  turnTowards(state, seeds[state.chosenSeed].face);
}

void nudgeSeed(AppState& state, const std::string& way, long steps) {
  if (steps < 1 || steps > kMostFaces) throw UsageError("A seed can go 1 to 1000 faces at once.");
  const Camera& camera = state.view.camera;
  const glm::dvec3 direction = way == "left"    ? -camera.right()
                               : way == "right" ? camera.right()
                               : way == "up"    ? camera.upward()
                                                : -camera.upward();
  const std::vector<PlacedSeed> seeds = state.presentSeeds();
  const auto free = [&](Index face) {
    return std::none_of(seeds.begin(), seeds.end(),
                        [&](const PlacedSeed& seed) { return seed.face == face; });
  };
  const Index start = seeds[state.chosenSeed].face;
  Index face = start;
  for (long i = 0; i < steps; ++i) {
    const Index next = faceTowards(*state.results().mesh, face, direction, camera.forward(), free);
    if (next == kNone) break;
    face = next;
  }
  if (face == start) throw Refusal("No free face lies that way.");
  moveSeed(state, state.chosenSeed, face, false);
  turnTowards(state, face);
}

void addChoosing(ActionRegistry& registry) {
  registry.add(
      {.id = "choose-seed",
       .title = "Choose a seed",
       .help = "The one that the arrow keys move: the next, the one before, or none.",
       .arguments =
           {{"which", ArgumentType::Choice, "which one", true, {"next", "previous", "none"}}},
       .refusal = needsSeeds,
       .run = [](AppState& state, const Arguments& a) { chooseSeed(state, a.text("which")); }});
  registry.bind("Tab", "choose-seed next", KeyPlace::SeedsTool);
  registry.bind("]", "choose-seed next", KeyPlace::SeedsTool);
  registry.bind("Shift+Tab", "choose-seed previous", KeyPlace::SeedsTool);
  registry.bind("[", "choose-seed previous", KeyPlace::SeedsTool);
}

void addMoving(ActionRegistry& registry) {
  registry.add(
      {.id = "nudge-seed",
       .title = "Move the chosen seed",
       .help = "To the next face in a direction of the picture; with Shift ten faces.",
       .arguments =
           {{"way", ArgumentType::Choice, "which way", true, {"left", "right", "up", "down"}},
            {"steps", ArgumentType::Integer, "how many faces", false}},
       .refusal = [](const AppState& state) -> std::string {
         return hasChosen(state) ? "" : "Choose a seed first: Tab in the seeds tool (G).";
       },
       .run = [](AppState& state,
                 const Arguments& a) { nudgeSeed(state, a.text("way"), a.integer("steps", 1)); }});
  const char* const kWays[][2] = {
      {"Left", "left"}, {"Right", "right"}, {"Up", "up"}, {"Down", "down"}};
  for (const auto& [key, way] : kWays) {
    const std::string line = std::string("nudge-seed ") + way;
    registry.bind(key, line, KeyPlace::SeedsTool);
    registry.bind(std::string("Shift+") + key, line + " steps=10", KeyPlace::SeedsTool);
  }
  registry.bind("Insert", "add-seed-in-view");
  registry.bind("Ctrl+L", "lock-seed");
}

}  // namespace

void addSeedKeyActions(ActionRegistry& registry) {
  addChoosing(registry);
  addMoving(registry);
}

}  // namespace chartflood
