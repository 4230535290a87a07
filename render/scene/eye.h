#pragma once
/// The camera as the shaders see it (common/eye.glsl), and the part of a picture that is drawn.

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "render/gl/program.h"
#include "render/scene/camera.h"

namespace chartflood {

/// A part of a picture, pixels. Pictures larger than a framebuffer are drawn part by part.
struct PicturePart {
  int wholeWidth = 1, wholeHeight = 1;
  int left = 0, bottom = 0;
  int width = 1, height = 1;

  static PicturePart whole(int width, int height) { return {width, height, 0, 0, width, height}; }
};

/// Uniforms of common/eye.glsl.
struct Eye {
  glm::mat4 view{1}, projection{1};
  glm::vec4 tile{1, 1, 0, 0};
  glm::vec2 viewport{1};
  float pixel = 1;
  bool orthographic = false;
};

Eye makeEye(const Camera& camera, const BoundingSphere& bounds, const PicturePart& part);

/// Scale and offset that stretch the part over the whole of clip space.
glm::vec4 tileOf(const PicturePart& part);

/// Sets them; the program must be in use.
void setEye(gl::Program& program, const Eye& eye);

}  // namespace chartflood
