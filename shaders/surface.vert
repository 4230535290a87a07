#version 330 core
#include "common/eye.glsl"

layout(location = 0) in vec3 aPosition;
layout(location = 1) in vec4 aNormal;

out vec3 vModel;   // place in model space
out vec3 vCamera;  // place in camera space
out vec3 vNormal;  // camera space, not of unit length

void main() {
  vModel = aPosition;
  vCamera = (uView * vec4(aPosition, 1.0)).xyz;
  vNormal = mat3(uView) * aNormal.xyz;
  gl_Position = tiled(uProjection * vec4(vCamera, 1.0));
}
