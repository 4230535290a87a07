#pragma once
/// What one user likes, kept from run to run. Never part of a result.

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "app/host/settings/film_preferences.h"
#include "app/host/settings/look.h"
#include "app/host/settings/picture_settings.h"
#include "app/host/settings/user_presets.h"

namespace chartflood {

/// When a slider's drag floods again at once.
enum class LiveMode { Auto, On, Off };

/// Which mouse buttons turn, move and zoom.
enum class NavigationStyle { Simple, Blender, Maya };

struct Preferences {
  ThemeKind theme = ThemeKind::Dark;
  double uiScale = 0;  ///< 0: as the screen proposes; else 0.75 to 2.5
  NavigationStyle navigation = NavigationStyle::Simple;
  bool invertZoom = false;
  bool trackball = false;  ///< turning is free; else the upright axis stays upright
  bool invertTurnX = false, invertTurnY = false;  ///< dragging right turns left, and so on
  bool explore = true;             ///< values are answered with finished charts; else with floods
  LiveMode live = LiveMode::Auto;  ///< where they are answered with floods
  FilmPreferences film;
  bool firstCard = true;    ///< the card of first steps is still to be shown
  bool askUnsaved = true;   ///< before unsaved changes would be lost
  PictureSettings picture;  ///< of the last picture
  int windowWidth = 1280;   ///< screen coordinates
  int windowHeight = 800;
  std::vector<std::string> recentFiles;  ///< newest first, at most kMostRecent

  std::vector<UserPreset> presets;  ///< in the order of saving
  /// Entries of the file that are no presets, as (name, JSON): written back as they were.
  std::vector<std::pair<std::string, std::string>> unusablePresets;

  static constexpr std::size_t kMostRecent = 10;

  bool operator==(const Preferences&) const = default;
};

/// The rows that do more than take a value.
inline constexpr const char* kTrackballSetting = "trackball";

/// What config.json holds beside pictures and presets; actions and options come from it, too.
const SettingTable<Preferences>& preferenceTable();
/// What state.json holds beside the recent files.
const SettingTable<Preferences>& windowPlaceTable();

/// Puts a file at the head of the recent ones.
void rememberFile(Preferences& preferences, const std::filesystem::path& file);

/// Reads config.json of `configFolder` and state.json of `stateFolder`; what is absent keeps its
/// default. A value of the wrong type or range, or a broken file, is left out and named in
/// `warning` (one sentence, "" if all was well).
Preferences readPreferences(const std::filesystem::path& configFolder,
                            const std::filesystem::path& stateFolder, std::string& warning);

/// Writes both files, making their folders. \throws WriteError
void writePreferences(const Preferences& preferences, const std::filesystem::path& configFolder,
                      const std::filesystem::path& stateFolder);

}  // namespace chartflood
