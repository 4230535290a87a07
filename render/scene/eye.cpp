#include "render/scene/eye.h"

#include <cmath>

namespace chartflood {

glm::vec4 tileOf(const PicturePart& part) {
  // Shifts the middle of the part to 0.
  const glm::vec2 whole(part.wholeWidth, part.wholeHeight);
  const glm::vec2 scale = whole / glm::vec2(part.width, part.height);
  const glm::vec2 middle =
      (glm::vec2(part.left, part.bottom) + 0.5f * glm::vec2(part.width, part.height)) / whole;
  return glm::vec4(scale, -(2.0f * middle - 1.0f) * scale);
}

Eye makeEye(const Camera& camera, const BoundingSphere& bounds, const PicturePart& part) {
  const double aspect = double(part.wholeWidth) / part.wholeHeight;
  Eye eye;
  eye.view = glm::mat4(camera.viewMatrix());
  eye.projection = glm::mat4(camera.projectionMatrix(aspect, bounds));
  eye.tile = tileOf(part);
  eye.viewport = glm::vec2(part.wholeWidth, part.wholeHeight);
  eye.orthographic = camera.orthographic;
  const double half =
      camera.orthographic ? camera.halfHeight() : std::tan(0.5 * camera.fieldOfView);
  eye.pixel = static_cast<float>(2 * half / part.wholeHeight);
  return eye;
}

void setEye(gl::Program& program, const Eye& eye) {
  program.set("uView", eye.view);
  program.set("uProjection", eye.projection);
  program.set("uTile", eye.tile);
  program.set("uViewport", eye.viewport);
  program.set("uPixel", eye.pixel);
  program.set("uOrthographic", eye.orthographic ? 1 : 0);
}

}  // namespace chartflood
