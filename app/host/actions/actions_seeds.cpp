// Actions of the hand on the seeds. Faces are those of the file, as with the option --seeds.

#include "app/host/actions/action_needs.h"
#include "app/host/actions/actions.h"
#include "app/host/actions/seed_edits.h"
#include "app/host/script/action_registry.h"
#include "app/host/state/app_state.h"

namespace chartflood {

namespace {

Index faceOf(const AppState& state, const Arguments& a) {
  const long face = a.integer("face", -1);
  const bool inRange = face >= 0 && face < static_cast<long>(kNone);
  const Index found = inRange ? meshFace(*state.results().mesh, static_cast<Index>(face)) : kNone;
  if (found == kNone) throw Refusal("The model has no face " + a.text("face") + '.');
  return found;
}

/// The named seed, or else the one under the mouse.
std::size_t seedOf(const AppState& state, const Arguments& a) {
  if (a.has("seed")) {
    const long seed = a.integer("seed");
    if (seed < 0) throw Refusal("There is no seed " + a.text("seed") + '.');
    return static_cast<std::size_t>(seed);
  }
  if (state.hoveredSeed != kNone) return state.hoveredSeed;
  if (state.chosenSeed < state.presentSeeds().size()) return state.chosenSeed;
  throw Refusal("Point at a seed with the Seeds tool (G) first, or choose one with Tab.");
}

const ArgumentInfo kSeed = {"seed", ArgumentType::Integer,
                            "its chart; left out: under the mouse or chosen", false};

PanelState::Tool toolOf(const Arguments& a) {
  const std::string name = a.text("name");
  return name == "seeds"   ? PanelState::Tool::Seeds
         : name == "hints" ? PanelState::Tool::Hints
                           : PanelState::Tool::Select;
}

void addTools(ActionRegistry& registry) {
  registry.add(
      {.id = "tool",
       .title = "Tool",
       .help = "Chooses what the mouse does on the model: select charts, work on seeds, or paint "
               "edges where seams are welcome or not.",
       .arguments =
           {{"name", ArgumentType::Choice, "which one", true, {"select", "seeds", "hints"}}},
       .refusal = {},
       .run =
           [](AppState& state, const Arguments& a) {
             state.panels.tool = toolOf(a);
             state.hoveredSeed = state.chosenSeed = kNone;
             if (state.panels.tool == PanelState::Tool::Seeds) state.view.render.seedMarks = true;
           },
       .checked = [](const AppState& state,
                     const Arguments& a) { return state.panels.tool == toolOf(a); }});
  registry.bind("V", "tool select");
  registry.bind("G", "tool seeds");
  registry.bind("Shift+G", "tool hints");
}

void addEdits(ActionRegistry& registry) {
  registry.add(
      {.id = "add-seed",
       .title = "Add a seed",
       .help = "One chart more, which begins at a face of the file.",
       .arguments = {{"face", ArgumentType::Integer, "of the file, from 0"}},
       .refusal = needsSeeds,
       .run = [](AppState& state, const Arguments& a) { addSeed(state, faceOf(state, a)); }});
  registry.add(
      {.id = "add-seed-in-view",
       .title = "Add at the centre of the view",
       .help = "One chart more, which begins where the middle of the 3D view shows.",
       .arguments = {},
       .refusal = needsSeeds,
       .run = [](AppState& state, const Arguments&) { state.requests.seedInView = true; }});
  registry.add({.id = "move-seed",
                .title = "Move a seed",
                .help = "Its chart begins at another face of the file.",
                .arguments = {{"seed", ArgumentType::Integer, "its chart"},
                              {"face", ArgumentType::Integer, "of the file, from 0"},
                              {"drag", ArgumentType::Switch, "more of this change follows", false}},
                .refusal = needsSeeds,
                .run = [](AppState& state, const Arguments& a) {
                  moveSeed(state, seedOf(state, a), faceOf(state, a), a.flag("drag", false));
                }});
  registry.add(
      {.id = "delete-seed",
       .title = "Delete a seed",
       .help = "One chart less; the last one stays.",
       .arguments = {kSeed},
       .refusal = needsSeeds,
       .run = [](AppState& state, const Arguments& a) { deleteSeed(state, seedOf(state, a)); }});
  registry.bind("Delete", "delete-seed");
  registry.add({.id = "put-back",
                .title = "Put the seed back",
                .help = "Ends the drag of a seed as if it had not been.",
                .arguments = {},
                .refusal = [](const AppState& state) -> std::string {
                  return state.seedDrag ? "" : "No seed is being dragged.";
                },
                .run =
                    [](AppState& state, const Arguments&) {
                      state.seedDrag.reset();
                      state.takeBackDrag();
                    }});
}

void addLocks(ActionRegistry& registry) {
  registry.add(
      {.id = "lock-seed",
       .title = "Lock a seed",
       .help = "A locked seed does not move in the rounds and outlives fewer charts.",
       .arguments = {kSeed, {"on", ArgumentType::Switch, "left out: turns it over", false}},
       .refusal = needsSeeds,
       .run = [](AppState& state, const Arguments& a) {
         const std::optional<bool> on =
             a.has("on") ? std::optional(a.flag("on", true)) : std::nullopt;
         lockSeed(state, seedOf(state, a), on);
       }});
  registry.add({.id = "clear-locks",
                .title = "Clear locks",
                .help = "Unlocks all seeds.",
                .arguments = {},
                .refusal = [](const AppState& state) -> std::string {
                  return lockedFaces(state.document().seeds).empty() ? "No seed is locked." : "";
                },
                .run = [](AppState& state, const Arguments&) { clearLocks(state); }});
}

}  // namespace

void addSeedActions(ActionRegistry& registry) {
  addTools(registry);
  addEdits(registry);
  addLocks(registry);
  registry.add({.id = "spread-seeds",
                .title = "Spread again",
                .help = "Another layout of all seeds that are not locked.",
                .arguments = {},
                .refusal = needsMesh,
                .run = [](AppState& state, const Arguments&) { spreadSeeds(state); }});
  registry.add({.id = "copy-seeds",
                .title = "Copy list of seeds",
                .help = "Copies the options that place these seeds.",
                .arguments = {},
                .refusal = needsSeeds,
                .run = [](AppState& state, const Arguments&) {
                  state.requests.clipboard = seedOptions(state);
                  state.notices.add(Notice::Kind::Info, "The list of seeds was copied.");
                }});
}

}  // namespace chartflood
