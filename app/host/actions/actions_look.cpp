// Actions for what a user likes: theme, simulated colour vision, mouse; and the search for actions.

#include "app/host/actions/actions.h"
#include "app/host/actions/setting_action.h"
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

/// Turned off, the upright axis comes upright again.
void setTrackball(AppState& state, const Setting<Preferences>& row, const Arguments& a) {
  setByAction(row, state.preferences, a);
  if (state.preferences.trackball) return;
  Camera& camera = state.view.camera;
  const bool z = camera.up == UpAxis::Z;
  camera.lookAlong(camera.forward(), z ? glm::dvec3(0, 0, 1) : glm::dvec3(0, 1, 0));
}

/// Whatever a user likes that has a title.
void addPreferences(ActionRegistry& registry) {
  for (const Setting<Preferences>& row : preferenceTable()) {
    if (*row.title == '\0') continue;
    Action action = settingAction(
        row, [](auto& state) -> auto& { return state.preferences; });
    if (std::string_view(row.id) == kTrackballSetting) {
      action.run = [&row](AppState& state, const Arguments& a) { setTrackball(state, row, a); };
    }
    addSetting(registry, row, std::move(action));
  }
}

}  // namespace

void addLookActions(ActionRegistry& registry) {
  addLooks(registry);
  addPreferences(registry);
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
