#pragma once
/// The viewer's eye: pure mathematics, no GL.
///
/// Picture coordinates are "ndc": x to the right and y up, both in [-1, 1] over the whole picture.
/// `aspect` is width over height. Angles are radians where not said otherwise.

#include <span>
#include <string_view>

#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace chartflood {

/// The direction of the model that stands upright in the picture.
enum class UpAxis { Y, Z };

enum class StandardView { Front, Back, Left, Right, Top, Bottom, Oblique };

/// Half a line in model space; `direction` has unit length.
struct Ray {
  glm::dvec3 origin{0};
  glm::dvec3 direction{0, 0, -1};
};

/// A sphere that holds the model; keeps the near and far planes around it.
struct BoundingSphere {
  glm::dvec3 center{0};
  double radius = 0.5;
};
BoundingSphere boundingSphere(std::span<const glm::dvec3> points);

/// Looks from `distance` behind `target` along its own -z axis.
struct Camera {
  glm::dvec3 target{0};                  ///< what the camera turns about
  glm::dquat orientation{1, 0, 0, 0};    ///< from camera to model axes
  double distance = 2;                   ///< from the eye to the target, > 0
  double fieldOfView = 0.5235987755982;  ///< vertical, radians (30 degrees)
  bool orthographic = false;             ///< the target plane keeps its size when switched
  UpAxis up = UpAxis::Y;

  bool operator==(const Camera&) const = default;

  glm::dvec3 right() const { return orientation * glm::dvec3(1, 0, 0); }
  glm::dvec3 upward() const { return orientation * glm::dvec3(0, 1, 0); }
  glm::dvec3 forward() const { return orientation * glm::dvec3(0, 0, -1); }
  glm::dvec3 eye() const { return target - distance * forward(); }
  /// Half the height of what is seen in the plane through the target.
  double halfHeight() const;

  /// Model to camera space.
  glm::dmat4 viewMatrix() const;
  /// Camera to clip space with near and far planes close around the sphere.
  glm::dmat4 projectionMatrix(double aspect, const BoundingSphere& bounds) const;
  /// Where a point of the model lies in the picture (x, y: ndc; z: depth, 1 at the far plane).
  glm::dvec3 project(const glm::dvec3& point, double aspect, const BoundingSphere& bounds) const;
  /// The line of sight through a place of the picture.
  Ray ray(const glm::dvec2& ndc, double aspect) const;

  /// Turns about the upright axis by `azimuth` (to the right: the model follows the hand) and about
  /// the picture's horizontal by `elevation`, which stops when looking straight up or down.
  void orbit(double azimuth, double elevation);
  /// Turns freely as if a ball were dragged from one place of the picture to another.
  void trackball(const glm::dvec2& fromNdc, const glm::dvec2& toNdc, double aspect);
  /// Shifts the picture so that what was at `fromNdc` (in the target's plane) comes to `toNdc`.
  void pan(const glm::dvec2& fromNdc, const glm::dvec2& toNdc, double aspect);
  /// Comes closer by `factor` > 1, keeping what is at `ndc` (in the target's plane) in its place.
  void zoom(double factor, const glm::dvec2& ndc, double aspect);
  /// Moves back or forth and sideways, without turning, until the points fill the picture up to
  /// `margin` (a share of the picture on each side, in [0, 0.3]); `rightInset` (a share of the
  /// width, in [0, 0.3]) stays free on the right. Does nothing without points.
  void frame(std::span<const glm::dvec3> points, double aspect, double margin = 0.06,
             double rightInset = 0);
  /// Turns to a standard view; the target and the distance stay.
  void look(StandardView view);
  /// Looks along `direction` (not zero) with `up` (or the upright axis when parallel) upwards.
  void lookAlong(const glm::dvec3& direction, const glm::dvec3& up);

  /// Angle about the upright axis and above the horizon, degrees, 0/0 for the front view.
  double azimuthDegrees() const;
  double elevationDegrees() const;

 private:
  glm::dvec3 upAxis() const;
  glm::dvec3 ballPoint(const glm::dvec2& ndc, double aspect) const;
};

/// "front", "back", "left", "right", "top", "bottom", "oblique". \throws UsageError otherwise.
StandardView standardViewFromId(std::string_view id);

}  // namespace chartflood
