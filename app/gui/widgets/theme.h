#pragma once
/// How the interface looks: colours, sizes and fonts at one scale.

#include <imgui.h>

#include "app/host/settings/look.h"

namespace chartflood {

/// Colours that panels draw with themselves.
struct Palette {
  ImU32 ground, panel, bar, popup, control, controlHovered, controlActive;
  ImU32 line;        ///< thin separators
  ImU32 text, dim;   ///< readable on every ground above and on `accentSoft`
  ImU32 accent;      ///< what is chosen, played or filled
  ImU32 accentSoft;  ///< the same behind text
  ImU32 front;       ///< playhead and flood front
  ImU32 good, warning, error;
  ImU32 veil;  ///< behind text that stands on a picture
  ImU32 axisX, axisY, axisZ;
  ImU32 ball, ballRim;  ///< the Gauss sphere
};

/// The colours of a theme. Text has a contrast of at least 4.5 with its grounds (WCAG 2.1, 1.4.3),
/// in the theme of high contrast 7 (1.4.6).
const Palette& themePalette(ThemeKind kind);

struct Theme {
  ThemeKind kind = ThemeKind::Dark;
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
Theme applyTheme(float scale, ThemeKind kind = ThemeKind::Dark);
/// Changes the colours alone; fonts and sizes stay.
void recolor(Theme& theme, ThemeKind kind);

}  // namespace chartflood
