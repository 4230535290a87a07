#pragma once
/// The 3D view while results are compared: halves side by side or a wipe, figures under each.

#include <algorithm>
#include <array>

#include "app/gui/tools/scene_panel.h"
#include "app/gui/widgets/ui.h"

namespace chartflood {

/// What the mouse is doing in each half; kept by the owner of the panel.
struct CompareMouse {
  std::array<SceneMouse, Compare::kMostPanes> sides;

  /// Time of the last movement of a camera.
  double movedAt() const {
    double latest = -10;
    for (const SceneMouse& side : sides) latest = std::max(latest, side.movedAt);
    return latest;
  }
};

/// Fills the present window. \pre state.compare.showing()
void comparePanel(const Ui& ui, SceneSource* source, CompareMouse& mouse);

}  // namespace chartflood
