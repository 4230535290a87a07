#pragma once
/// How the interface looks: colours, sizes and fonts at one scale.

#include <imgui.h>

namespace chartflood {

/// Colours that panels draw with themselves.
struct Palette {
  ImU32 ground, panel, bar, control, controlHovered, controlActive;
  ImU32 line;        ///< thin separators
  ImU32 text, dim;   ///< contrast on `panel` at least 7 and 4.5
  ImU32 accent;      ///< what is chosen, played or filled
  ImU32 accentSoft;  ///< the same behind text
  ImU32 front;       ///< playhead and flood front
  ImU32 good, warning, error;
};

struct Theme {
  float scale = 1;            ///< 1 is a 15 pixel text
  ImFont* regular = nullptr;  ///< text
  ImFont* strong = nullptr;   ///< headings and figures
  ImFont* small = nullptr;    ///< ticks, hints, subscripts
  Palette palette{};

  /// Pixels for a length given at scale 1, whole.
  float px(float length) const;
};

/// Sets the style of the current Dear ImGui context and fills its font atlas (not yet uploaded).
/// `scale` from 0.75 to 2.5. Call between frames.
Theme applyTheme(float scale);

}  // namespace chartflood
