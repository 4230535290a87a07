// Actions that keep the work: saving, the question before it would be lost, what a crash left.

#include "app/host/actions/action_needs.h"
#include "app/host/actions/actions.h"
#include "app/host/script/action_registry.h"
#include "app/host/state/app_state.h"
#include "core/base/error.h"

namespace chartflood {

namespace {

std::string needsQuestion(const AppState& state) {
  return state.panels.unsavedQuestion ? "" : "Nothing was asked.";
}

std::string needsLeft(const AppState& state) {
  return state.keeper.recovery.left().empty() ? "No session was left behind." : "";
}

/// Saves under a name that ends as session files do, then does what has waited for it.
void saveAs(AppState& state, std::filesystem::path file) {
  if (!isSessionFile(file)) file += kSessionEnding;
  state.saveSession(file);
  state.notices.add(Notice::Kind::Info, "Saved " + file.filename().string() + '.');
  state.goOn();
}

void save(AppState& state, const std::string& file) {
  if (!file.empty()) return saveAs(state, file);
  if (!state.keeper.file().empty()) return saveAs(state, state.keeper.file());
  state.panels.browse = PanelState::Browse::SaveSession;
}

void answer(AppState& state, const std::string& how) {
  state.panels.unsavedQuestion = false;
  if (how == "save") return save(state, "");
  if (how == "discard") return state.goOn();
  state.giveUp();
}

void addQuestion(ActionRegistry& registry) {
  registry.add({.id = "answer",
                .title = "Answer",
                .help = "Answers the question about unsaved changes.",
                .arguments = {{"how",
                               ArgumentType::Choice,
                               "what to do with them",
                               true,
                               {"save", "discard", "cancel"}}},
                .refusal = needsQuestion,
                .run = [](AppState& state, const Arguments& a) { answer(state, a.text("how")); }});
}

void addRecovery(ActionRegistry& registry) {
  registry.add({.id = "restore-session",
                .title = "Restore",
                .help = "Goes on with the session that ended unexpectedly.",
                .arguments = {},
                .refusal = needsLeft,
                .run = [](AppState& state, const Arguments&) {
                  state.whenSafe([](AppState& s) {
                    const std::filesystem::path copy = s.keeper.recovery.left().front();
                    SessionFile session = readSession(copy);
                    const std::filesystem::path file = session.continues;
                    s.openSession(std::move(session), file, copy);
                  });
                }});
  registry.add({.id = "forget-session",
                .title = "Forget",
                .help = "Throws away the session that ended unexpectedly.",
                .arguments = {},
                .refusal = needsLeft,
                .run = [](AppState& state, const Arguments&) { state.keeper.recovery.forget(); }});
}

}  // namespace

void addSessionActions(ActionRegistry& registry) {
  registry.add(
      {.id = "save-session",
       .title = "Save session",
       .help = "Saves model, parameters, seeds, charts and view to go on another day.",
       .arguments = {{"file", ArgumentType::Text, "left out: the last one, or asks", false}},
       .refusal = needsMesh,
       .run = [](AppState& state, const Arguments& a) { save(state, a.text("file")); }});
  registry.bind("Ctrl+S", "save-session");
  registry.add({.id = "save-session-as",
                .title = "Save session as\u2026",
                .help = "Saves the session under another name.",
                .arguments = {},
                .refusal = needsMesh,
                .run = [](AppState& state, const Arguments&) {
                  state.panels.browse = PanelState::Browse::SaveSession;
                }});
  registry.bind("Ctrl+Shift+S", "save-session-as");
  addQuestion(registry);
  addRecovery(registry);
}

}  // namespace chartflood
