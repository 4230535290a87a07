// Actions that change parameters, and undo.

#include <algorithm>

#include "app/host/actions/actions.h"
#include "app/host/actions/seed_edits.h"
#include "app/host/script/action_registry.h"
#include "app/host/settings/slider_scale.h"
#include "app/host/state/app_state.h"
#include "core/base/error.h"
#include "core/base/spelling.h"

namespace chartflood {

namespace {

std::vector<std::string> presetIds() {
  std::vector<std::string> ids;
  for (const Preset& preset : presetTable()) ids.emplace_back(preset.id);
  return ids;
}

const ParameterInfo& parameterRow(const std::string& id) {
  if (const ParameterInfo* info = findParameter(id)) return *info;
  std::vector<std::string> ids;
  for (const ParameterInfo& info : parameterTable()) ids.emplace_back(info.id);
  const std::string nearest = nearestSpelling(id, ids);
  throw UsageError("There is no parameter '" + id + "'" +
                   (nearest.empty() ? "." : "; did you mean '" + nearest + "'?"));
}

std::string valueText(const ParameterInfo& info, const Parameters& values) {
  const ParameterValue value = parameterValue(values, info);
  const bool number = std::holds_alternative<int>(value) || std::holds_alternative<double>(value);
  return number ? sliderText(info, asNumber(value)) : parameterText(value);
}

/// "K 20 to 24", as undo names the change; a drag tells its two ends.
std::string changeName(const AppState& state, const ParameterInfo& info, const Parameters& after) {
  const UndoStep* begun = state.undoHistory().joined(info.id);
  const Parameters& before =
      begun != nullptr ? begun->document.parameters : state.document().parameters;
  const std::string name = std::string_view(info.id) == "charts" ? info.symbol : info.label;
  return name + ' ' + valueText(info, before) + " to " + valueText(info, after);
}

void setOption(AppState& state, const std::string& id, const std::string& text, bool dragging) {
  const ParameterInfo& info = parameterRow(id);
  Document document = state.document();
  setParameterFromText(document.parameters, info, text);
  state.changeDocument(document, changeName(state, info, document.parameters), id, dragging);
}

void resetOption(AppState& state, const ParameterInfo& info) {
  Document document = state.document();
  resetParameter(document.parameters, info);
  state.changeDocument(document, changeName(state, info, document.parameters), info.id, false);
}

void changeAll(AppState& state, const Parameters& parameters, std::string name) {
  Document document = state.document();
  document.parameters = parameters;
  state.changeDocument(document, std::move(name), "all", false);
}

int chartsNow(const AppState& state) {
  return inForce(state.document().parameters, state.results().features).charts;
}

void addCharts(AppState& state, int difference) {
  const int charts = std::max(1, chartsNow(state) + difference);
  setOption(state, "charts", std::to_string(charts), false);
}

void addParameterActions(ActionRegistry& registry) {
  registry.add({.id = "set",
                .title = "Set a parameter",
                .help = "Gives a parameter a new value.",
                .arguments = {{"option", ArgumentType::Text, "its name on the command line"},
                              {"value", ArgumentType::Text, "the new value"},
                              {"drag", ArgumentType::Switch, "more of this change follows", false}},
                .refusal = {},
                .run = [](AppState& state, const Arguments& a) {
                  setOption(state, a.text("option"), a.text("value"), a.flag("drag", false));
                }});
  registry.add({.id = "reset",
                .title = "Reset a parameter",
                .help = "Gives a parameter its default value.",
                .arguments = {{"option", ArgumentType::Text, "its name on the command line"}},
                .refusal = {},
                .run = [](AppState& state, const Arguments& a) {
                  resetOption(state, parameterRow(a.text("option")));
                }});
  registry.add(
      {.id = "reset-all",
       .title = "Reset all parameters",
       .help = "Gives every parameter its default value.",
       .arguments = {},
       .refusal = [](const AppState& state) -> std::string {
         return state.document().parameters == Parameters{}
                    ? "All parameters have their default values."
                    : "";
       },
       .run = [](AppState& state,
                 const Arguments&) { changeAll(state, Parameters{}, "Reset all parameters"); }});
  registry.add({.id = "preset",
                .title = "Preset",
                .help = "Sets the parameters for a purpose; the number of charts stays unless the "
                        "preset names it.",
                .arguments = {{"name", ArgumentType::Choice, "which one", true, presetIds()}},
                .refusal = {},
                .run = [](AppState& state, const Arguments& a) {
                  const Preset& preset = *findPreset(a.text("name"));
                  changeAll(state, applyPreset(state.document().parameters, preset),
                            std::string("Preset: ") + preset.label);
                }});
  registry.add({.id = "more-charts",
                .title = "One chart more",
                .help = "Cuts the model into one more chart.",
                .arguments = {},
                .refusal = {},
                .run = [](AppState& state, const Arguments&) { addCharts(state, 1); }});
  registry.bind("+", "more-charts");
  registry.add({.id = "fewer-charts",
                .title = "One chart less",
                .help = "Cuts the model into one chart less.",
                .arguments = {},
                .refusal = [](const AppState& state) -> std::string {
                  return chartsNow(state) <= 1 ? "One chart is the least." : "";
                },
                .run = [](AppState& state, const Arguments&) { addCharts(state, -1); }});
  registry.bind("-", "fewer-charts");
  registry.add({.id = "roll-seed",
                .title = "Another layout",
                .help = "Starts from seeds placed with another random number.",
                .arguments = {},
                .refusal = {},
                .run = [](AppState& state, const Arguments&) { spreadSeeds(state); }});
}

}  // namespace

void addEditActions(ActionRegistry& registry) {
  registry.add({.id = "undo",
                .title = "Undo",
                .help = "Takes the last change of parameters or seeds back.",
                .arguments = {},
                .refusal = [](const AppState& state) -> std::string {
                  return state.undoHistory().canUndo() ? "" : "There is nothing to undo.";
                },
                .run = [](AppState& state, const Arguments&) { state.undo(); }});
  registry.bind("Ctrl+Z", "undo");
  registry.add({.id = "redo",
                .title = "Redo",
                .help = "Repeats what was undone.",
                .arguments = {},
                .refusal = [](const AppState& state) -> std::string {
                  return state.undoHistory().canRedo() ? "" : "There is nothing to redo.";
                },
                .run = [](AppState& state, const Arguments&) { state.redo(); }});
  registry.bind("Ctrl+Shift+Z", "redo");
  registry.bind("Ctrl+Y", "redo");
  addParameterActions(registry);
  registry.add({.id = "copy-command",
                .title = "Copy as command line",
                .help = "Copies a command line that gives the present parameters and model.",
                .arguments = {},
                .refusal = {},
                .run = [](AppState& state, const Arguments&) {
                  state.requests.clipboard = commandLine(state);
                  state.notices.add(Notice::Kind::Info, "The command line was copied.");
                }});
  registry.bind("Ctrl+Shift+C", "copy-command");
}

}  // namespace chartflood
