#pragma once
/// How single settings of the view are named, read off and set; for the files that list them.

#include <functional>
#include <string>
#include <variant>
#include <vector>

#include "app/host/settings/view_settings.h"
#include "core/session/files/session_io.h"

namespace chartflood {

using Numbers = std::vector<double>;

/// One named setting: how it is read off and set. `set` says whether the value could be used.
struct ViewRow {
  const char* name;
  std::function<SessionValue(const ViewSettings&)> get;
  std::function<bool(ViewSettings&, const SessionValue&)> set;
  std::function<bool(const ViewSettings&)> present = {};  ///< none: always
};

/// A switch in a part of the settings.
template <typename Part>
ViewRow viewSwitch(const char* name, Part ViewSettings::*part, bool Part::*member) {
  return {name, [=](const ViewSettings& view) { return SessionValue(view.*part.*member); },
          [=](ViewSettings& view, const SessionValue& value) {
            const bool* on = std::get_if<bool>(&value);
            if (on != nullptr) view.*part.*member = *on;
            return on != nullptr;
          }};
}

/// The numbers of a value when there are `count` finite ones, else null.
const Numbers* viewNumbers(const SessionValue& value, std::size_t count);

/// From where the model, the texture and the Gauss sphere are looked at.
std::vector<ViewRow> cameraRows();

}  // namespace chartflood
