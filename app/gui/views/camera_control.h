#pragma once
/// From drags and the wheel to movements of the camera.

#include <imgui.h>

#include "app/host/settings/preferences.h"
#include "render/scene/camera.h"

namespace chartflood {

enum class CameraMotion { None, Orbit, Pan, Zoom };

/// What a drag with a button (0 left, 1 right, 2 middle) does in a navigation style.
CameraMotion motionOf(NavigationStyle style, int button, bool shift, bool ctrl, bool alt);

/// A part of the window that shows the camera's picture.
struct ViewRectangle {
  ImVec2 min{0, 0}, max{1, 1};

  double width() const { return static_cast<double>(max.x) - static_cast<double>(min.x); }
  double height() const { return static_cast<double>(max.y) - static_cast<double>(min.y); }
  double aspect() const { return width() / height(); }
  /// Picture coordinates of a place in the window.
  glm::dvec2 ndc(ImVec2 place) const;
};

/// Moves the camera by a drag from one place of the window to another.
void dragCamera(Camera& camera, CameraMotion motion, const ViewRectangle& view, ImVec2 from,
                ImVec2 to, const Preferences& likes);

/// One notch of the wheel forward comes closer to what is under the mouse.
void wheelCamera(Camera& camera, const ViewRectangle& view, ImVec2 place, float notches,
                 bool invertZoom);

}  // namespace chartflood
