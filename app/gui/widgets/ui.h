#pragma once
/// What every panel is given: the state it shows, the actions it emits, and how to draw.

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "app/gui/widgets/probe.h"
#include "app/gui/widgets/theme.h"
#include "app/host/script/action_registry.h"
#include "app/host/state/app_state.h"

namespace chartflood {

/// What the widgets must remember between frames: never a value of the document.
struct UiMemory {
  std::string hovered;       ///< label of the widget under the mouse, for the tooltip's delay
  double hoveredSince = 0;   ///< seconds of ImGui::GetTime()
  bool hoveredSeen = false;  ///< submitted in this frame
  std::string typing;        ///< label of the slider that is being typed into
  std::string typed;         ///< what was typed so far
  bool typingBegins = false;
  std::string presetName;          ///< what was typed as the name of a preset
  std::string searched;            ///< what was typed into the search for actions
  std::size_t searchRow = 0;       ///< the chosen line below it
  bool searchOpen = false;         ///< it was open in the last frame
  Index pointed = kNone;           ///< chart that a plot or list says is under the mouse
  std::vector<ImU32> chartColors;  ///< as on the model, by number; empty: not known
  /// Under the mouse in the last frame; out of range: none. Readouts stand above their plots.
  std::array<std::size_t, 3> binUnderMouse{kNowhere, kNowhere, kNowhere};
  std::size_t roundUnderMouse = kNowhere, runUnderMouse = kNowhere;
  static constexpr std::size_t kNowhere = static_cast<std::size_t>(-1);
  float leftWidth = 0, rightWidth = 0;  ///< pixels; 0: not laid out yet
  double wakeIn = 1e9;                  ///< seconds until the next frame is needed
};

struct Ui {
  AppState& state;
  const ActionRegistry& actions;
  const Theme& theme;
  Probe& probe;
  UiMemory& memory;

  /// Runs a script line; failures become toasts.
  void run(std::string_view line) const { state.perform(actions, line); }
  float px(float length) const { return theme.px(length); }
  /// Says that a chart is under the mouse, in this frame.
  void pointAt(Index chart) const { memory.pointed = chart; }
  /// Asks for another frame at the latest after so many seconds.
  void wakeIn(double seconds) const {
    if (seconds < memory.wakeIn) memory.wakeIn = seconds;
  }
};

}  // namespace chartflood
