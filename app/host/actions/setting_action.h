#pragma once
/// For the files of actions: one action a row of a table of settings, which gives it a value.

#include <string>

#include "app/host/script/action_registry.h"
#include "app/host/settings/setting.h"
#include "app/host/state/app_state.h"
#include "core/base/error.h"

namespace chartflood {

/// The value as an argument of the row's action.
template <typename Owner>
ArgumentInfo settingArgument(const Setting<Owner>& row) {
  const SettingDomain& domain = row.value.domain;
  if (row.isSwitch()) return {"on", ArgumentType::Switch, "left out: turns it over", false};
  ArgumentInfo argument{row.argument, ArgumentType::Text, allowedText(domain)};
  if (domain.type == SettingType::Whole) argument.type = ArgumentType::Integer;
  if (domain.type == SettingType::Number) argument.type = ArgumentType::Number;
  if (!domain.words.empty()) argument.type = ArgumentType::Text;
  if (domain.type != SettingType::Choice) return argument;
  argument.type = ArgumentType::Choice;
  argument.help = "which one";
  for (const SettingChoice& each : domain.choices) {
    argument.choices.push_back(each.id);
    argument.labels.push_back(each.label);
    if (!each.former.empty()) argument.former.push_back(each.former);
  }
  return argument;
}

/// Gives the row the action's value, or turns a switch over. \throws UsageError
template <typename Owner>
void setByAction(const Setting<Owner>& row, Owner& owner, const Arguments& a) {
  if (row.isSwitch()) {
    row.set(owner, a.flag("on", !std::get<bool>(row.get(owner))));
    return;
  }
  const std::string text = a.text(row.argument), reason = row.setText(owner, text);
  if (!reason.empty()) throw UsageError(refusalText(row.id, text, reason, row.value.domain));
}

/// The row's action. `place` gives its owner in an AppState, constant or not.
/// \pre the row lives as long as the program
template <typename Owner, typename Place>
Action settingAction(const Setting<Owner>& row, Place place) {
  return {.id = row.id,
          .title = row.title,
          .help = row.help,
          .arguments = {settingArgument(row)},
          .refusal = {},
          .run = [&row, place](AppState& state,
                               const Arguments& a) { setByAction(row, place(state), a); },
          .checked =
              [&row, place](const AppState& state, const Arguments& a) {
                const Owner& owner = place(state);
                return row.isSwitch() ? std::get<bool>(row.get(owner))
                                      : row.has(owner, a.text(row.argument));
              },
          .former = row.former};
}

/// Adds the action of a row with its key.
template <typename Owner>
void addSetting(ActionRegistry& registry, const Setting<Owner>& row, Action action) {
  registry.add(std::move(action));
  if (*row.key != '\0') registry.bind(row.key, row.id);
}

}  // namespace chartflood
