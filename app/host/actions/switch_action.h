#pragma once
/// For the files of actions: one that turns something on, off, or over.

#include "app/host/script/action_registry.h"
#include "app/host/state/app_state.h"

namespace chartflood {

/// `place` gives the bool in an AppState, constant or not. `key` "" binds none.
template <typename Place>
void addSwitch(ActionRegistry& registry, const char* id, const char* title, const char* help,
               const char* key, Place place) {
  registry.add(
      {.id = id,
       .title = title,
       .help = help,
       .arguments = {{"on", ArgumentType::Switch, "left out: turns it over", false}},
       .refusal = {},
       .run =
           [place](AppState& state, const Arguments& a) {
             bool& value = place(state);
             value = a.flag("on", !value);
           },
       .checked = [place](const AppState& state, const Arguments&) { return place(state); }});
  if (*key != '\0') registry.bind(key, id);
}

}  // namespace chartflood
