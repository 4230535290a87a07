#pragma once
/// The UV tab: the charts laid flat, linked with the 3D view.

#include "app/gui/views/uv_view.h"
#include "app/gui/widgets/ui.h"

namespace chartflood {

/// What the mouse is doing in the texture; kept by the owner of the panel.
struct UvMouse {
  int button = -1;       ///< that was pressed inside, -1: none
  float travelled = 0;   ///< pixels since then
  double movedAt = -10;  ///< time of the last movement of the texture, ImGui::GetTime()
  ImVec2 pickedAt{-1, -1};
  Index face = kNone;       ///< under the mouse, as told to the state
  Index menuChart = kNone;  ///< whose menu is open
};

/// Fills the rest of the present window. `elsewhere`: the 3D view is being moved.
void uvPanel(const Ui& ui, UvSource* source, UvMouse& mouse, bool elsewhere);
/// To be called in frames that do not show it.
void leaveUv(const Ui& ui, UvMouse& mouse);

}  // namespace chartflood
