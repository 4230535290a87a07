#include "app/host/settings/look.h"

#include <algorithm>
#include <array>

namespace chartflood {

namespace {

constexpr std::array kThemes = {
    ThemeInfo{ThemeKind::Dark, "dark", "Dark"}, ThemeInfo{ThemeKind::Light, "light", "Light"},
    ThemeInfo{ThemeKind::HighContrast, "high-contrast", "High contrast"}};

}  // namespace

std::span<const ThemeInfo> themeTable() { return kThemes; }

const ThemeInfo& themeInfo(ThemeKind kind) { return kThemes[static_cast<std::size_t>(kind)]; }

const ThemeInfo* findTheme(std::string_view id) {
  const auto found = std::find_if(kThemes.begin(), kThemes.end(),
                                  [&](const ThemeInfo& theme) { return theme.id == id; });
  return found == kThemes.end() ? nullptr : &*found;
}

Background themeGround(ThemeKind kind) {
  switch (kind) {
  case ThemeKind::Light:
    return {glm::vec3(0.86f), glm::vec3(0.94f)};
  case ThemeKind::HighContrast:
    return {glm::vec3(0), glm::vec3(0)};
  case ThemeKind::Dark:
    break;
  }
  return {};
}

Background shownGround(const Background& chosen, ThemeKind kind) {
  return chosen == Background{} ? themeGround(kind) : chosen;
}

}  // namespace chartflood
