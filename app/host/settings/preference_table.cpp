// What a user likes, one row each: files, actions, menus and options come from them.

#include <algorithm>

#include "app/host/settings/preferences.h"

namespace chartflood {

namespace {

constexpr NamedValue<NavigationStyle> kNavigationStyles[] = {
    {NavigationStyle::Simple, "simple", "Simple: left turns, middle moves"},
    {NavigationStyle::Blender, "blender", "Blender: middle turns, Shift+middle moves"},
    {NavigationStyle::Maya, "maya", "Maya: Alt+left turns, Alt+middle moves"}};

constexpr NamedValue<LiveMode> kLiveModes[] = {{LiveMode::Auto, "auto", "When a flood is quick"},
                                               {LiveMode::On, "on", "Always"},
                                               {LiveMode::Off, "off", "Never: only when let go"}};

/// A factor; 0 or "auto" is what the screen proposes, and scripts may give it in per cent.
SettingSource<Preferences> scaleOfInterface() {
  SettingDomain domain{.type = SettingType::Number, .least = 0.75, .most = 2.5, .words = {"auto"}};
  const auto set = [domain](Preferences& likes, const SettingValue& value) -> std::string {
    const std::string* word = std::get_if<std::string>(&value);
    const double* number = std::get_if<double>(&value);
    const bool asScreen =
        (word != nullptr && *word == "auto") || (number != nullptr && *number == 0);
    const double factor = number == nullptr ? 0 : *number >= 75 ? *number / 100 : *number;
    std::string reason;
    if (!asScreen) reason = number == nullptr ? "is not a number" : valueProblem(domain, factor);
    if (reason.empty()) likes.uiScale = factor;
    return reason;
  };
  return {domain, [](const Preferences& likes) { return likes.uiScale; }, set};
}

/// Screens change: a window that was too small or large is brought to what can be.
SettingSource<Preferences> sideOfWindow(int Preferences::*member, double least) {
  constexpr double kMost = 16384;
  return checkedSource<Preferences, double>(
      {.type = SettingType::Whole, .least = -1e9, .most = 1e9},
      [=](const Preferences& likes) { return static_cast<double>(likes.*member); },
      [=](Preferences& likes, double side) {
        likes.*member = static_cast<int>(std::clamp(side, least, kMost));
      });
}

SettingTable<Preferences> makeRows() {
  using P = Preferences;
  SettingTable<P> rows = {
      {.id = "theme",
       .title = "Theme",
       .help = "Colours of the window; the ground behind the model follows.",
       .value = oneOfTable<P>(
           [](auto& likes) -> auto& { return likes.theme; }, themeTable(), &ThemeInfo::kind),
       .argument = "name",
       .note = ", or as last",
       .option = true},
      {.id = "ui-scale",
       .title = "Size of the interface",
       .help = "Size of text and controls, 0.75 to 2.5; 0: as the screen proposes.",
       .value = scaleOfInterface(),
       .argument = "percent",
       .option = true},
      {.id = "navigation",
       .title = "Mouse like",
       .help = "Chooses which mouse buttons turn, move and zoom.",
       .value =
           oneOf(&P::navigation, std::span<const NamedValue<NavigationStyle>>(kNavigationStyles)),
       .argument = "style",
       .note = ", or as last",
       .option = true},
      {"invert-zoom", "Invert the zoom", "The wheel turned forward goes away from the model.",
       onOff(&P::invertZoom)},
      {kTrackballSetting, "Turn freely (trackball)",
       "Dragging turns the model like a ball in the hand; off: its upright axis stays upright.",
       onOff(&P::trackball)},
      {"invert-turn-x", "Invert turning sideways", "Dragging to the right turns to the left.",
       onOff(&P::invertTurnX)},
      {"invert-turn-y", "Invert turning up and down", "Dragging up turns down.",
       onOff(&P::invertTurnY)},
      {"explore", "Explore",
       "Changed values are answered with finished charts: a sketch while a slider is dragged, then "
       "what a batch run gives. Off: one flood at a time, to be watched.",
       onOff(&P::explore)},
      {.id = "live",
       .title = "Live",
       .help = "Whether dragging a slider floods at once while floods are watched. Auto: when a "
               "flood is quick.",
       .value = oneOf(&P::live, std::span<const NamedValue<LiveMode>>(kLiveModes)),
       .argument = "when"},
      {"first-steps", "", "The card of first steps is still to be shown.", onOff(&P::firstCard)},
      {"ask-unsaved", "Ask before unsaved work is lost",
       "Whether to ask before unsaved changes of parameters or seeds are lost.",
       onOff(&P::askUnsaved)}};
  append(rows, lifted(filmSettingTable(), &P::film));
  return rows;
}

}  // namespace

const SettingTable<Preferences>& preferenceTable() {
  static const SettingTable<Preferences> rows = makeRows();
  return rows;
}

const SettingTable<Preferences>& windowPlaceTable() {
  static const SettingTable<Preferences> rows = {
      {"window-width", "", "Screen coordinates.", sideOfWindow(&Preferences::windowWidth, 640)},
      {"window-height", "", "Screen coordinates.", sideOfWindow(&Preferences::windowHeight, 480)}};
  return rows;
}

}  // namespace chartflood
