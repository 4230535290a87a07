// Actions for what a user likes: theme, simulated colour vision, mouse; and the search for actions.

#include "app/host/actions/actions.h"
#include "app/host/actions/switch_action.h"
#include "app/host/script/action_registry.h"
#include "app/host/state/app_state.h"
#include "core/base/error.h"

namespace chartflood {

namespace {

template <typename Table>
std::vector<std::string> idsOf(const Table& table) {
  std::vector<std::string> ids;
  for (const auto& row : table) ids.emplace_back(row.id);
  return ids;
}

void addLooks(ActionRegistry& registry) {
  registry.add(
      {.id = "theme",
       .title = "Theme",
       .help = "Chooses the colours of the window; the ground behind the model follows.",
       .arguments = {{"name", ArgumentType::Choice, "which one", true, idsOf(themeTable())}},
       .refusal = {},
       .run = [](AppState& state,
                 const Arguments& a) { state.preferences.theme = findTheme(a.text("name"))->kind; },
       .checked =
           [](const AppState& state, const Arguments& a) {
             return themeInfo(state.preferences.theme).id == a.text("name");
           }});
  registry.add(
      {.id = "simulate",
       .title = "Simulate colour blindness",
       .help = "Shows model and texture as the colour-blind see them. Saved pictures keep their "
               "colours.",
       .arguments = {{"kind", ArgumentType::Choice, "which one", true, idsOf(colorVisionTable())}},
       .refusal = {},
       .run =
           [](AppState& state, const Arguments& a) {
             state.view.vision = findColorVision(a.text("kind"))->vision;
           },
       .checked =
           [](const AppState& state, const Arguments& a) {
             return colorVisionInfo(state.view.vision).id == a.text("kind");
           }});
}

void addInversions(ActionRegistry& registry) {
  const auto add = [&](const char* id, const char* title, const char* help,
                       bool Preferences::*member) {
    addSwitch(
        registry, id, title, help,
        "", [member](auto& state) -> auto& { return state.preferences.*member; });
  };
  add("invert-zoom", "Invert the zoom", "The wheel turned forward goes away from the model.",
      &Preferences::invertZoom);
  add("invert-turn-x", "Invert turning sideways", "Dragging to the right turns to the left.",
      &Preferences::invertTurnX);
  add("invert-turn-y", "Invert turning up and down", "Dragging up turns down.",
      &Preferences::invertTurnY);
}

/// Free turning; without it the upright axis comes upright again.
void addTrackball(ActionRegistry& registry) {
  registry.add({.id = "trackball",
                .title = "Turn freely (trackball)",
                .help = "Dragging turns the model like a ball in the hand; off: its upright axis "
                        "stays upright.",
                .arguments = {{"on", ArgumentType::Switch, "left out: turns it over", false}},
                .refusal = {},
                .run =
                    [](AppState& state, const Arguments& a) {
                      bool& on = state.preferences.trackball;
                      on = a.flag("on", !on);
                      if (on) return;
                      Camera& camera = state.view.camera;
                      const bool z = camera.up == UpAxis::Z;
                      camera.lookAlong(camera.forward(),
                                       z ? glm::dvec3(0, 0, 1) : glm::dvec3(0, 1, 0));
                    },
                .checked = [](const AppState& state,
                              const Arguments&) { return state.preferences.trackball; }});
}

}  // namespace

void addLookActions(ActionRegistry& registry) {
  addLooks(registry);
  addInversions(registry);
  addTrackball(registry);
  addSwitch(
      registry, "preferences", "Preferences", "Theme, sizes, mouse and habits.", "Ctrl+,",
      [](auto& state) -> auto& { return state.panels.preferences; });
  addSwitch(
      registry, "find-action", "Find an action",
      "Type a few letters of what you want to do, or a parameter with its value: charts 30.",
      "Ctrl+P", [](auto& state) -> auto& { return state.panels.search; });
  registry.bind("Ctrl+Shift+P", "find-action");
  registry.add({.id = "show-parameter",
                .title = "Show a parameter",
                .help = "Brings the row of a parameter into view and gives it the keyboard.",
                .arguments = {{"option", ArgumentType::Choice, "its name on the command line", true,
                               idsOf(parameterTable())}},
                .refusal = {},
                .run = [](AppState& state, const Arguments& a) {
                  state.panels.left = true;
                  state.panels.shownParameter = a.text("option");
                }});
}

}  // namespace chartflood
