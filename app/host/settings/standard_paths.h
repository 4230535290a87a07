#pragma once
/// The user's folders by the XDG base directory rules. Variables that are unset, empty or relative
/// fall back to the standard places under the home folder.

#include <filesystem>

namespace chartflood {

/// Preferences: $XDG_CONFIG_HOME/chartflood or ~/.config/chartflood.
std::filesystem::path configFolder();
/// What is remembered from run to run: $XDG_STATE_HOME/chartflood or ~/.local/state/chartflood.
std::filesystem::path stateFolder();
/// Screenshots: $XDG_PICTURES_DIR/chartflood or ~/Pictures/chartflood.
std::filesystem::path picturesFolder();
/// The user's home, or the root folder when none is known.
std::filesystem::path homeFolder();

}  // namespace chartflood
