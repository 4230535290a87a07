#include "app/cli/camera_options.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "render/scene/first_view.h"

namespace chartflood {

namespace {

glm::dvec3 normalised(const Mesh& mesh, const glm::dvec3& point) {
  return (point - mesh.center()) / mesh.scale();
}

glm::dvec3 upOf(const Camera& camera, const CameraOptions& options) {
  if (options.viewUp) return *options.viewUp;
  return camera.up == UpAxis::Z ? glm::dvec3(0, 0, 1) : glm::dvec3(0, 1, 0);
}

/// The direction of sight, whichever way it was given; nothing: the standard one.
std::optional<glm::dvec3> sight(const Mesh& mesh, const CameraOptions& options) {
  if (options.direction) return options.direction;
  if (!options.position) return std::nullopt;
  // A position alone looks at the middle of the model.
  const glm::dvec3 target = options.focalPoint.value_or(mesh.center());
  const glm::dvec3 direction = target - *options.position;
  return direction == glm::dvec3(0) ? std::nullopt : std::optional(direction);
}

/// Moves the eye to the given position; the orientation stays.
void placeEye(Camera& camera, const Mesh& mesh, const CameraOptions& options) {
  const glm::dvec3 eye = normalised(mesh, *options.position);
  const glm::dvec3 target =
      options.focalPoint ? normalised(mesh, *options.focalPoint) : glm::dvec3(0);
  const double distance = glm::length(target - eye);
  if (options.direction || distance == 0) {
    camera.target = eye + camera.forward() * camera.distance;
  } else {
    camera.target = target;
    camera.distance = distance;
  }
}

}  // namespace

Camera cameraFromOptions(const Mesh& mesh, const CameraOptions& options, double aspect) {
  if (options.saved && !options.given) return *options.saved;
  Camera camera;
  camera.up = options.up.value_or(likelyUpAxis(mesh));
  camera.orthographic = options.orthographic;
  if (options.viewAngle) camera.fieldOfView = glm::radians(*options.viewAngle);
  lookAtFirst(camera, mesh);
  const auto direction = sight(mesh, options);
  if (direction || options.viewUp) {
    camera.lookAlong(direction.value_or(camera.forward()), upOf(camera, options));
  }
  camera.orbit(glm::radians(options.azimuthAngle), glm::radians(options.elevationAngle));
  camera.frame(mesh.positions(), aspect);
  if (options.focalPoint) camera.target = normalised(mesh, *options.focalPoint);
  if (options.position) placeEye(camera, mesh, options);
  if (options.zoomFactor != 1) camera.zoom(options.zoomFactor, glm::dvec2(0), aspect);
  return camera;
}

}  // namespace chartflood
