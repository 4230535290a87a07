// Cameras of the view in session files.

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "app/host/files/session_view_rows.h"

namespace chartflood {

const Numbers* viewNumbers(const SessionValue& value, std::size_t count) {
  const Numbers* list = std::get_if<Numbers>(&value);
  if (list == nullptr || list->size() != count) return nullptr;
  const bool finite =
      std::all_of(list->begin(), list->end(), [](double x) { return std::isfinite(x); });
  return finite ? list : nullptr;
}

namespace {

/// Degrees that give the angle again, to the last bit.
double exactDegrees(double angle) {
  double degrees = glm::degrees(angle);
  for (const double toward : {0.0, 360.0}) {
    double near = degrees;
    for (int step = 0; step < 4 && glm::radians(near) != angle; ++step) {
      near = std::nextafter(near, toward);
    }
    if (glm::radians(near) == angle) return near;
  }
  return degrees;
}

/// Target, orientation (w, x, y, z), distance, field of view (degrees), in this order.
SessionValue cameraOf(const ViewSettings& view) {
  const Camera& c = view.camera;
  return Numbers{c.target.x,      c.target.y,      c.target.z,
                 c.orientation.w, c.orientation.x, c.orientation.y,
                 c.orientation.z, c.distance,      exactDegrees(c.fieldOfView)};
}

bool readCamera(ViewSettings& view, const SessionValue& value) {
  const Numbers* n = viewNumbers(value, 9);
  if (n == nullptr) return false;
  const glm::dquat turn((*n)[3], (*n)[4], (*n)[5], (*n)[6]);
  const double length = glm::length(turn), distance = (*n)[7], angle = (*n)[8];
  // Normalised units: beyond these nothing of the model could be seen.
  const bool sane = length > 1e-3 && length < 1e3 && distance > 1e-9 && distance < 1e6 &&
                    angle >= 1 && angle <= 170;
  if (!sane) return false;
  view.camera.target = {(*n)[0], (*n)[1], (*n)[2]};
  // Written with all digits: a turn of unit length is taken as it is.
  view.camera.orientation = std::abs(length - 1) < 1e-12 ? turn : glm::normalize(turn);
  view.camera.distance = distance;
  view.camera.fieldOfView = glm::radians(angle);
  view.frameWhenLoaded = false;
  return true;
}

std::vector<ViewRow> modelCameraRows() {
  return {{"camera", cameraOf, readCamera,
           [](const ViewSettings& view) { return !view.frameWhenLoaded; }},
          {"camera-orthographic",
           [](const ViewSettings& view) { return SessionValue(view.camera.orthographic); },
           [](ViewSettings& view, const SessionValue& value) {
             const bool* on = std::get_if<bool>(&value);
             if (on != nullptr) view.camera.orthographic = *on;
             return on != nullptr;
           }},
          {"up",
           [](const ViewSettings& view) {
             return SessionValue(std::string(view.camera.up == UpAxis::Z ? "+Z" : "+Y"));
           },
           [](ViewSettings& view, const SessionValue& value) {
             const std::string* axis = std::get_if<std::string>(&value);
             if (axis == nullptr || (*axis != "+Y" && *axis != "+Z")) return false;
             view.camera.up = *axis == "+Z" ? UpAxis::Z : UpAxis::Y;
             return true;
           }}};
}

/// Middle (u, v) and span.
SessionValue uvCameraOf(const ViewSettings& view) {
  const UvCamera& c = view.uvCamera;
  return Numbers{c.center.x, c.center.y, c.span};
}

bool readUvCamera(ViewSettings& view, const SessionValue& value) {
  const Numbers* n = viewNumbers(value, 3);
  if (n == nullptr) return false;
  const double u = (*n)[0], v = (*n)[1], span = (*n)[2];
  const bool sane = std::abs(u) < UvCamera::kMostSpan && std::abs(v) < UvCamera::kMostSpan &&
                    span >= UvCamera::kLeastSpan && span <= UvCamera::kMostSpan;
  if (sane) view.uvCamera = {{u, v}, span};
  return sane;
}

std::vector<ViewRow> uvRows() {
  return {viewSwitch("uv-fill", &ViewSettings::uv, &UvStyle::fill),
          viewSwitch("uv-frame", &ViewSettings::uv, &UvStyle::frame),
          {"uv-camera", uvCameraOf, readUvCamera}};
}

/// Orientation (w, x, y, z) of the Gauss sphere where it does not turn with the model.
SessionValue sphereTurnOf(const ViewSettings& view) {
  const glm::dquat& turn = view.sphereCamera.orientation;
  return Numbers{turn.w, turn.x, turn.y, turn.z};
}

bool readSphereTurn(ViewSettings& view, const SessionValue& value) {
  const Numbers* n = viewNumbers(value, 4);
  if (n == nullptr) return false;
  const glm::dquat turn((*n)[0], (*n)[1], (*n)[2], (*n)[3]);
  const double length = glm::length(turn);
  if (length < 1e-3 || length > 1e3) return false;
  view.sphereCamera.orientation = std::abs(length - 1) < 1e-12 ? turn : glm::normalize(turn);
  return true;
}

std::vector<ViewRow> sphereRows() {
  const auto linked = [](const ViewSettings& view) { return SessionValue(view.sphereLinked); };
  const auto link = [](ViewSettings& view, const SessionValue& value) {
    const bool* on = std::get_if<bool>(&value);
    if (on != nullptr) view.sphereLinked = *on;
    return on != nullptr;
  };
  return {{"sphere-linked", linked, link},
          {"sphere-turn", sphereTurnOf, readSphereTurn,
           [](const ViewSettings& view) { return !view.sphereLinked; }}};
}

}  // namespace

std::vector<ViewRow> cameraRows() {
  std::vector<ViewRow> rows;
  for (const std::vector<ViewRow>& part : {modelCameraRows(), uvRows(), sphereRows()}) {
    rows.insert(rows.end(), part.begin(), part.end());
  }
  return rows;
}

}  // namespace chartflood
