#pragma once
/// The 3D view: its picture, the mouse on it, hints and axes over it.

#include "app/gui/views/camera_control.h"
#include "app/gui/views/scene_view.h"
#include "app/gui/widgets/ui.h"

namespace chartflood {

/// What the mouse is doing in the view; kept by the owner of the panel.
struct SceneMouse {
  static constexpr float kClickTravel = 4;  ///< a press that moves less is a click, pixels

  ComparePane pane;      ///< the half of a comparison that it is in
  Index face = kNone;    ///< last found under it
  int button = -1;       ///< that was pressed inside the view, -1: none
  float travelled = 0;   ///< pixels since then
  double movedAt = -10;  ///< time of the last movement of the camera, ImGui::GetTime()
  ImVec2 pickedAt{-1, -1};
  bool hovering = false;  ///< the mouse was over the view in the last frame
  /// The whole model was framed and the camera not moved since: it stays whole when the view
  /// changes its size.
  bool framed = false;
  double framedAspect = 0;
  // Of the seeds tool, from the press of a button to its release.
  Index seed = kNone;        ///< that was under the mouse when it was pressed
  bool seedDragged = false;  ///< it was moved since then, or put back
  bool clickAdded = false;   ///< the last click added a seed
  Index menuSeed = kNone;    ///< whose menu is open
  Index menuChart = kNone;   ///< the same of a chart
};

/// So long after the last movement the pictures are drawn smoothly.
inline constexpr double kSettleSeconds = 0.2;
/// A press that moves less, in pixels, is a click.
inline constexpr float kClickTravel = 4;

/// Frames the model when it is due; `view` is where the active camera's picture stands.
void frameModel(AppState& state, const ViewRectangle& view, SceneMouse& mouse);
/// The mouse in one view of the model, as a widget of this name.
void sceneMouse(const Ui& ui, SceneSource* source, const ViewRectangle& view, SceneMouse& mouse,
                const char* label);
/// The model's picture; `from` and `to` are shares of its width that are shown.
void scenePicture(const Ui& ui, SceneSource* source, const ViewRectangle& view,
                  const SceneMouse& mouse, float from = 0, float to = 1);
/// Fills the present window. Without a source the ground is drawn alone.
void scenePanel(const Ui& ui, SceneSource* source, SceneMouse& mouse);

}  // namespace chartflood
