#include "render/scene/camera.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/trigonometric.hpp>

#include "core/base/error.h"

namespace chartflood {

namespace {

constexpr double kClosest = 1e-6;  // of a distance, in model units
constexpr double kFarthest = 1e6;

/// Direction of sight and picture's upward direction of a standard view, for Y up.
std::pair<glm::dvec3, glm::dvec3> standardAxes(StandardView view) {
  switch (view) {
  case StandardView::Front:
    return {{0, 0, -1}, {0, 1, 0}};
  case StandardView::Back:
    return {{0, 0, 1}, {0, 1, 0}};
  case StandardView::Left:
    return {{1, 0, 0}, {0, 1, 0}};
  case StandardView::Right:
    return {{-1, 0, 0}, {0, 1, 0}};
  case StandardView::Top:
    return {{0, -1, 0}, {0, 0, -1}};
  case StandardView::Bottom:
    return {{0, 1, 0}, {0, 0, 1}};
  case StandardView::Oblique:
    return {{-0.5, -0.42, -0.85}, {0, 1, 0}};
  }
  return {{0, 0, -1}, {0, 1, 0}};
}

/// Turns the axes of a Y-up model into those of a Z-up one (front looks along +y).
glm::dvec3 toZUp(const glm::dvec3& v) { return {v.x, -v.z, v.y}; }

}  // namespace

BoundingSphere boundingSphere(std::span<const glm::dvec3> points) {
  if (points.empty()) return {};
  glm::dvec3 low(std::numeric_limits<double>::max());
  glm::dvec3 high(std::numeric_limits<double>::lowest());
  for (const glm::dvec3& point : points) {
    low = glm::min(low, point);
    high = glm::max(high, point);
  }
  BoundingSphere sphere{0.5 * (low + high), 0};
  for (const glm::dvec3& point : points) {
    sphere.radius = std::max(sphere.radius, glm::distance(point, sphere.center));
  }
  return sphere;
}

glm::dvec3 Camera::upAxis() const {
  return up == UpAxis::Y ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, 1);
}

double Camera::halfHeight() const { return distance * std::tan(0.5 * fieldOfView); }

glm::dmat4 Camera::viewMatrix() const {
  return glm::mat4_cast(glm::conjugate(orientation)) * glm::translate(glm::dmat4(1), -eye());
}

glm::dmat4 Camera::projectionMatrix(double aspect, const BoundingSphere& bounds) const {
  const double depth = glm::dot(bounds.center - eye(), forward());
  // Room for lines and marks, which are drawn a little in front of the surface.
  const double radius = std::max(bounds.radius, 1e-9) * 1.05;
  const double half = halfHeight();
  if (orthographic) {
    return glm::ortho(-half * aspect, half * aspect, -half, half, depth - radius, depth + radius);
  }
  const double farPlane = std::max(depth + radius, 1e-6);
  const double nearPlane = std::max(depth - radius, 1e-3 * std::min(radius, farPlane));
  return glm::perspective(fieldOfView, aspect, nearPlane, std::max(farPlane, nearPlane * 1.001));
}

glm::dvec3 Camera::project(const glm::dvec3& point, double aspect,
                           const BoundingSphere& bounds) const {
  const glm::dvec4 clip = projectionMatrix(aspect, bounds) * viewMatrix() * glm::dvec4(point, 1);
  return glm::dvec3(clip) / clip.w;
}

Ray Camera::ray(const glm::dvec2& ndc, double aspect) const {
  const double half = halfHeight();
  const glm::dvec3 inPlane = target + right() * (ndc.x * half * aspect) + upward() * (ndc.y * half);
  if (orthographic) return {inPlane - forward() * distance, forward()};
  return {eye(), glm::normalize(inPlane - eye())};
}

void Camera::orbit(double azimuth, double elevation) {
  const double now = std::asin(std::clamp(-glm::dot(forward(), upAxis()), -1.0, 1.0));
  // Past the pole the picture would turn upside down; a tilted camera (trackball) is not held.
  const bool upright = std::abs(glm::dot(right(), upAxis())) < 1e-6;
  const double quarter = glm::half_pi<double>();
  const double turn = upright ? std::clamp(now + elevation, -quarter, quarter) - now : elevation;
  orientation =
      glm::angleAxis(-azimuth, upAxis()) * orientation * glm::angleAxis(-turn, glm::dvec3(1, 0, 0));
  orientation = glm::normalize(orientation);
}

glm::dvec3 Camera::ballPoint(const glm::dvec2& ndc, double aspect) const {
  const glm::dvec2 place(ndc.x * aspect, ndc.y);
  const double squared = glm::dot(place, place);
  // A sphere in the middle that runs out into a hyperbola (Bell's trackball), so that the turn
  // never jumps.
  const double depth = squared <= 0.5 ? std::sqrt(1 - squared) : 0.5 / std::sqrt(squared);
  return glm::normalize(glm::dvec3(place, depth));
}

void Camera::trackball(const glm::dvec2& fromNdc, const glm::dvec2& toNdc, double aspect) {
  const glm::dvec3 from = ballPoint(fromNdc, aspect), to = ballPoint(toNdc, aspect);
  const glm::dvec3 axis = glm::cross(from, to);
  const double sine = glm::length(axis);
  if (sine < 1e-12) return;
  const double angle = 2 * std::atan2(sine, glm::dot(from, to));
  orientation = glm::normalize(orientation * glm::angleAxis(-angle, axis / sine));
}

void Camera::pan(const glm::dvec2& fromNdc, const glm::dvec2& toNdc, double aspect) {
  const glm::dvec2 shift = (fromNdc - toNdc) * halfHeight();
  target += right() * (shift.x * aspect) + upward() * shift.y;
}

void Camera::zoom(double factor, const glm::dvec2& ndc, double aspect) {
  const double before = halfHeight();
  distance = std::clamp(distance / factor, kClosest, kFarthest);
  const double change = before - halfHeight();
  target += right() * (ndc.x * change * aspect) + upward() * (ndc.y * change);
}

void Camera::frame(std::span<const glm::dvec3> points, double aspect, double margin,
                   double rightInset) {
  if (points.empty()) return;
  // Slopes of the four sides that the points shall touch.
  const double slope = std::tan(0.5 * fieldOfView);
  const double ty = slope * (1 - 2 * margin), tl = ty * aspect;
  const double tr = tl - 2 * rightInset * slope * aspect;
  const double lean = orthographic ? 0 : 1;
  const glm::dquat toCamera = glm::conjugate(orientation);
  constexpr double kLowest = std::numeric_limits<double>::lowest();
  double east = kLowest, west = kLowest, north = kLowest, south = kLowest;
  double nearest = kLowest, farthest = -kLowest;
  for (const glm::dvec3& point : points) {
    const glm::dvec3 p = toCamera * point;
    east = std::max(east, p.x + p.z * tr * lean);
    west = std::max(west, -p.x + p.z * tl * lean);
    north = std::max(north, p.y + p.z * ty * lean);
    south = std::max(south, -p.y + p.z * ty * lean);
    nearest = std::max(nearest, p.z);
    farthest = std::min(farthest, p.z);
  }
  // On the right x + z tr <= ex + ez tr must hold for the eye (ex, ey, ez), and so on; the tighter
  // pair of sides says how far away it must be.
  const double middle = 0.5 * (nearest + farthest);
  const double away = std::max((east + west) / (tl + tr), (north + south) / (2 * ty));
  distance = std::clamp(orthographic ? away : away - middle, kClosest, kFarthest);
  const double sideways = 0.5 * (east - west + away * (tl - tr));
  target = orientation * glm::dvec3(sideways, 0.5 * (north - south), middle);
}

void Camera::look(StandardView view) {
  auto [direction, upwards] = standardAxes(view);
  if (up == UpAxis::Z) {
    direction = toZUp(direction);
    upwards = toZUp(upwards);
  }
  lookAlong(direction, upwards);
}

void Camera::lookAlong(const glm::dvec3& direction, const glm::dvec3& upwards) {
  const glm::dvec3 back = -glm::normalize(direction);
  glm::dvec3 side = glm::cross(upwards, back);
  if (glm::length(side) < 1e-9) side = glm::cross(upAxis(), back);
  if (glm::length(side) < 1e-9) side = glm::cross(glm::dvec3(1, 0, 0), back);
  side = glm::normalize(side);
  orientation = glm::normalize(glm::quat_cast(glm::dmat3(side, glm::cross(back, side), back)));
}

double Camera::azimuthDegrees() const {
  const glm::dvec3 side = right();
  const double sine = up == UpAxis::Y ? -side.z : side.y;
  return glm::degrees(std::atan2(sine, side.x));
}

double Camera::elevationDegrees() const {
  return glm::degrees(std::asin(std::clamp(-glm::dot(forward(), upAxis()), -1.0, 1.0)));
}

StandardView standardViewFromId(std::string_view id) {
  constexpr std::pair<std::string_view, StandardView> kViews[] = {
      {"front", StandardView::Front},    {"back", StandardView::Back},
      {"left", StandardView::Left},      {"right", StandardView::Right},
      {"top", StandardView::Top},        {"bottom", StandardView::Bottom},
      {"oblique", StandardView::Oblique}};
  for (const auto& [name, view] : kViews) {
    if (name == id) return view;
  }
  throw UsageError("There is no view \"" + std::string(id) +
                   "\"; choose front, back, left, right, top, bottom or oblique.");
}

}  // namespace chartflood
