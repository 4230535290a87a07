#version 330 core
#include "common/eye.glsl"

layout(location = 0) in vec3 aPosition;
layout(location = 2) in vec3 aTexture;

void main() {
#ifdef IN_TEXTURE
  gl_Position = inTexture(aTexture.xy);
#else
  gl_Position = tiled(uProjection * (uView * vec4(aPosition, 1.0)));
#endif
}
