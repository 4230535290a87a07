#include "app/host/script/action_registry.h"

#include <algorithm>
#include <utility>

#include "core/base/check.h"
#include "core/base/error.h"
#include "core/base/spelling.h"
#include "core/session/settings/parameters.h"

namespace chartflood {

void ActionRegistry::add(Action action) {
  CF_CHECK(find(action.id) == nullptr);
  actions_.push_back(std::move(action));
}

void ActionRegistry::bind(std::string_view chord, std::string_view line, KeyPlace place) {
  const Chord parsed = parseChord(chord);
  CF_CHECK(findBinding(parsed, place) == nullptr);
  const Command command = parseCommand(line);
  // Throws when the line's arguments are not the action's.
  const Arguments checked(command.action, at(command.action).arguments, command.arguments);
  bindings_.push_back({parsed, std::string(line), place});
}

const Action* ActionRegistry::find(std::string_view id) const {
  const auto found =
      std::find_if(actions_.begin(), actions_.end(), [&](const Action& a) { return a.id == id; });
  if (found != actions_.end()) return &*found;
  const auto former = std::find_if(actions_.begin(), actions_.end(), [&](const Action& a) {
    return !a.former.empty() && a.former == id;
  });
  return former == actions_.end() ? nullptr : &*former;
}

const Action& ActionRegistry::at(std::string_view id) const {
  if (const Action* action = find(id)) return *action;
  std::vector<std::string> ids;
  for (const Action& action : actions_) ids.push_back(action.id);
  const std::string nearest = nearestSpelling(id, ids);
  throw UsageError("There is no action '" + std::string(id) + "'" +
                   (nearest.empty() ? "." : "; did you mean '" + nearest + "'?"));
}

const Binding* ActionRegistry::findBinding(const Chord& chord, KeyPlace place) const {
  const auto found = std::find_if(bindings_.begin(), bindings_.end(), [&](const Binding& b) {
    return b.chord == chord && b.place == place;
  });
  return found == bindings_.end() ? nullptr : &*found;
}

std::string ActionRegistry::shortcut(std::string_view line) const {
  const auto found = std::find_if(bindings_.begin(), bindings_.end(),
                                  [&](const Binding& b) { return b.line == line; });
  return found == bindings_.end() ? std::string() : chordText(found->chord);
}

std::string ActionRegistry::refusal(std::string_view line, const AppState& state) const {
  const Action& action = at(parseCommand(line).action);
  return action.refusal ? action.refusal(state) : std::string();
}

bool ActionRegistry::checked(std::string_view line, const AppState& state) const {
  const Command command = parseCommand(line);
  const Action& action = at(command.action);
  return action.checked &&
         action.checked(state, Arguments(action.id, action.arguments, command.arguments));
}

void ActionRegistry::run(std::string_view line, AppState& state) const {
  const Command command = parseCommand(line);
  if (command.action.empty()) return;
  const Action& action = at(command.action);
  const Arguments arguments(action.id, action.arguments, command.arguments);
  if (action.refusal) {
    if (const std::string reason = action.refusal(state); !reason.empty()) throw Refusal(reason);
  }
  action.run(state, arguments);
}

}  // namespace chartflood
