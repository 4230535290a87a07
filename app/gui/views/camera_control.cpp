#include "app/gui/views/camera_control.h"

#include <cmath>
#include <numbers>

namespace chartflood {

namespace {

constexpr double kWheelFactor = 1.15;       // closer by this per notch
constexpr double kDragZoom = 4;             // e-folds over the height of the view
constexpr double kTurn = std::numbers::pi;  // radians over the height of the view

CameraMotion simpleMotion(int button, bool shift) {
  if (button == 2 || (button == 0 && shift)) return CameraMotion::Pan;
  return button == 1 ? CameraMotion::Zoom : CameraMotion::Orbit;
}

CameraMotion blenderMotion(int button, bool shift, bool ctrl) {
  if (button != 2) return CameraMotion::None;
  if (shift) return CameraMotion::Pan;
  return ctrl ? CameraMotion::Zoom : CameraMotion::Orbit;
}

CameraMotion mayaMotion(int button, bool alt) {
  if (!alt) return CameraMotion::None;
  constexpr CameraMotion kByButton[] = {CameraMotion::Orbit, CameraMotion::Zoom, CameraMotion::Pan};
  return kByButton[button];
}

}  // namespace

CameraMotion motionOf(NavigationStyle style, int button, bool shift, bool ctrl, bool alt) {
  switch (style) {
  case NavigationStyle::Blender:
    return blenderMotion(button, shift, ctrl);
  case NavigationStyle::Maya:
    return mayaMotion(button, alt);
  case NavigationStyle::Simple:
    break;
  }
  return simpleMotion(button, shift);
}

glm::dvec2 ViewRectangle::ndc(ImVec2 place) const {
  return {2 * static_cast<double>(place.x - min.x) / width() - 1,
          1 - 2 * static_cast<double>(place.y - min.y) / height()};
}

void dragCamera(Camera& camera, CameraMotion motion, const ViewRectangle& view, ImVec2 from,
                ImVec2 to, const Preferences& likes) {
  const double dx = static_cast<double>(to.x - from.x) / view.height();
  const double dy = static_cast<double>(to.y - from.y) / view.height();
  switch (motion) {
  case CameraMotion::Orbit:
    if (likes.trackball) {
      const ImVec2 end{likes.invertTurnX ? 2 * from.x - to.x : to.x,
                       likes.invertTurnY ? 2 * from.y - to.y : to.y};
      return camera.trackball(view.ndc(from), view.ndc(end), view.aspect());
    }
    return camera.orbit(kTurn * (likes.invertTurnX ? -dx : dx),
                        kTurn * (likes.invertTurnY ? -dy : dy));
  case CameraMotion::Pan:
    return camera.pan(view.ndc(from), view.ndc(to), view.aspect());
  case CameraMotion::Zoom:
    return camera.zoom(std::exp(kDragZoom * (likes.invertZoom ? -dy : dy)), {0, 0}, view.aspect());
  case CameraMotion::None:
    return;
  }
}

void wheelCamera(Camera& camera, const ViewRectangle& view, ImVec2 place, float notches,
                 bool invertZoom) {
  const double steps = invertZoom ? -static_cast<double>(notches) : static_cast<double>(notches);
  camera.zoom(std::pow(kWheelFactor, steps), view.ndc(place), view.aspect());
}

}  // namespace chartflood
