#pragma once
/// What a user chooses about the look of the window: theme, and a simulated kind of colour vision.

#include <span>
#include <string_view>

#include "render/scene/color_vision.h"
#include "render/scene/render_settings.h"

namespace chartflood {

enum class ThemeKind { Dark, Light, HighContrast };

/// A theme as options, preferences and menus name it.
struct ThemeInfo {
  ThemeKind kind;
  const char* id;
  const char* label;
};
/// One row a theme, in the order of the menu.
std::span<const ThemeInfo> themeTable();
const ThemeInfo& themeInfo(ThemeKind kind);
/// The theme with this id, or nullptr.
const ThemeInfo* findTheme(std::string_view id);

/// The ground behind the model where none was chosen.
Background themeGround(ThemeKind kind);
/// The ground to be drawn: the default one is the theme's.
Background shownGround(const Background& chosen, ThemeKind kind);

}  // namespace chartflood
