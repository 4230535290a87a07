// Actions on the user's own presets: save, use, rename, delete, bring back.

#include <algorithm>
#include <utility>

#include "app/host/actions/actions.h"
#include "app/host/script/action_registry.h"
#include "app/host/script/command.h"
#include "app/host/state/app_state.h"
#include "core/base/error.h"
#include "core/base/spelling.h"

namespace chartflood {

namespace {

/// \throws UsageError that names the nearest one
UserPreset& ownPreset(AppState& state, const std::string& name) {
  std::vector<UserPreset>& presets = state.preferences.presets;
  std::vector<std::string> names;
  for (UserPreset& preset : presets) {
    if (preset.name == name) return preset;
    names.push_back(preset.name);
  }
  const std::string nearest = nearestSpelling(name, names);
  throw UsageError("There is no preset of yours called '" + name + "'" +
                   (nearest.empty() ? "." : "; did you mean '" + nearest + "'?"));
}

void requireFreeName(const AppState& state, const std::string& name) {
  const std::string problem = presetNameProblem(state.preferences.presets, name);
  if (!problem.empty()) throw Refusal(problem);
}

void usePreset(AppState& state, const std::string& name) {
  std::string warning;
  Document document = state.document();
  document.parameters = applyUserPreset(document.parameters, ownPreset(state, name), warning);
  if (!warning.empty()) state.notices.add(Notice::Kind::Warning, warning);
  state.changeDocument(document, "Preset: " + name, "all", false);
}

void deletePreset(AppState& state, const std::string& name) {
  std::vector<UserPreset>& presets = state.preferences.presets;
  const auto place = &ownPreset(state, name) - presets.data();
  state.deletedPreset = presets[static_cast<std::size_t>(place)];
  presets.erase(presets.begin() + place);
  state.notices.add(Notice::Kind::Info,
                    "Deleted the preset '" + name + "'. Edit > Presets brings it back.");
  state.keepPreferences();
}

std::string noneDeleted(const AppState& state) {
  return state.deletedPreset ? "" : "No preset was deleted.";
}

void restorePreset(AppState& state) {
  requireFreeName(state, state.deletedPreset->name);
  state.preferences.presets.push_back(*std::exchange(state.deletedPreset, std::nullopt));
  state.keepPreferences();
}

const ArgumentInfo kName{"name", ArgumentType::Text, "what it is called"};

void addNaming(ActionRegistry& registry) {
  registry.add({.id = "name-preset",
                .title = "Save as a preset",
                .help = "Keeps the present parameters under a name.",
                .arguments = {{"name", ArgumentType::Text, "one that is to be renamed", false}},
                .refusal = {},
                .run = [](AppState& state, const Arguments& a) {
                  if (a.has("name")) ownPreset(state, a.text("name"));
                  state.panels.renamedPreset = a.text("name");
                  state.panels.namesPreset = true;
                }});
  registry.add(
      {.id = "close-naming",
       .title = "Cancel",
       .help = "Gives no name.",
       .arguments = {},
       .refusal = {},
       .run = [](AppState& state, const Arguments&) { state.panels.namesPreset = false; }});
}

}  // namespace

void addPresetActions(ActionRegistry& registry) {
  addNaming(registry);
  registry.add(
      {.id = "own-preset",
       .title = "Own preset",
       .help = "Sets the parameters as they were when the preset was saved.",
       .arguments = {kName},
       .refusal = {},
       .run = [](AppState& state, const Arguments& a) { usePreset(state, a.text("name")); }});
  registry.add({.id = "save-preset",
                .title = "Save",
                .help = "Keeps the present parameters under a name.",
                .arguments = {kName},
                .refusal = {},
                .run = [](AppState& state, const Arguments& a) {
                  requireFreeName(state, a.text("name"));
                  state.preferences.presets.push_back(
                      userPresetOf(a.text("name"), state.document().parameters));
                  state.panels.namesPreset = false;
                  state.keepPreferences();
                }});
  registry.add({.id = "rename-preset",
                .title = "Rename",
                .help = "Gives a preset of yours another name.",
                .arguments = {kName, {"to", ArgumentType::Text, "the new name"}},
                .refusal = {},
                .run = [](AppState& state, const Arguments& a) {
                  UserPreset& preset = ownPreset(state, a.text("name"));
                  if (a.text("to") != preset.name) requireFreeName(state, a.text("to"));
                  preset.name = a.text("to");
                  state.panels.namesPreset = false;
                  state.keepPreferences();
                }});
  registry.add(
      {.id = "delete-preset",
       .title = "Delete",
       .help = "Forgets a preset of yours; it can be brought back until the next one.",
       .arguments = {kName},
       .refusal = {},
       .run = [](AppState& state, const Arguments& a) { deletePreset(state, a.text("name")); }});
  registry.add({.id = "restore-preset",
                .title = "Bring the deleted preset back",
                .help = "Puts the preset that was deleted last back into the list.",
                .arguments = {},
                .refusal = noneDeleted,
                .run = [](AppState& state, const Arguments&) { restorePreset(state); }});
}

}  // namespace chartflood
