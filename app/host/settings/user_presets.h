#pragma once
/// Sets of parameters that the user has given a name to, kept with the preferences.

#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/session/settings/parameters.h"

namespace chartflood {

/// Values by option as written, so that what another version knows is kept when it is unknown here.
struct UserPreset {
  std::string name;
  std::vector<std::pair<std::string, std::string>> values;

  bool operator==(const UserPreset&) const = default;
};

/// The number of charts and what differs from the defaults, but for the random seed.
UserPreset userPresetOf(std::string name, const Parameters& parameters);

/// Its values over the defaults; the random seed of `base` stays, the number of charts too unless
/// it is among them. `warning` gets one sentence about values that cannot be used, "" without any.
Parameters applyUserPreset(const Parameters& base, const UserPreset& preset, std::string& warning);

/// The preset of this name, or nullptr.
const UserPreset* findUserPreset(std::span<const UserPreset> presets, std::string_view name);

/// Why no new preset can be called that, as one sentence; "" when one can.
std::string presetNameProblem(std::span<const UserPreset> presets, std::string_view name);

}  // namespace chartflood
