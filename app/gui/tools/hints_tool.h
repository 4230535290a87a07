#pragma once
/// The brush on edges in the 3D view.

#include "app/gui/tools/scene_panel.h"

namespace chartflood {

/// A button went down in the view: begins a stroke where the model is under the mouse.
void pressBrush(const Ui& ui, SceneSource* source, const ViewRectangle& view,
                const SceneMouse& mouse);
/// While it is down and a stroke is under way: leads it on. Call every frame.
void dragBrush(const Ui& ui, SceneSource* source, const ViewRectangle& view);
/// It went up: paints the stroke.
void releaseBrush(const Ui& ui);

/// What the brush does, as three buttons in the present row.
void brushSwitch(const Ui& ui);

}  // namespace chartflood
