#pragma once
/// The hand on the seeds in the 3D view: which seed is under the mouse, what clicks and drags do to
/// it, its menu, and the switch between the tools.

#include "app/gui/tools/scene_panel.h"
#include "app/gui/views/camera_control.h"
#include "app/gui/widgets/ui.h"

namespace chartflood {

/// What lies under a place of the window.
Pick pickAt(SceneSource* source, const ViewRectangle& view, ImVec2 place);

/// The nearest seed whose mark can be seen within a few pixels of a place; kNone: none.
Index seedAt(const Ui& ui, SceneSource* source, const ViewRectangle& view, ImVec2 place);

/// A button went down in the view: takes hold of the seed there, if any.
void pressSeed(const Ui& ui, SceneSource* source, const ViewRectangle& view, SceneMouse& mouse);
/// While it is down and a seed is held: moves it. Call every frame.
void dragSeed(const Ui& ui, SceneSource* source, const ViewRectangle& view, SceneMouse& mouse);
/// It went up: ends the drag, or does what a click does.
void releaseSeed(const Ui& ui, SceneSource* source, const ViewRectangle& view, SceneMouse& mouse);

/// The menu of a seed that was right-clicked, and seeds asked for by actions.
void seedMenu(const Ui& ui, SceneSource* source, const ViewRectangle& view, SceneMouse& mouse);

/// A button a tool in the corner of the area.
void toolSwitch(const Ui& ui, ImVec2 areaMin);

}  // namespace chartflood
