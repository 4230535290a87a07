#version 330 core
#include "common/eye.glsl"

layout(location = 0) in vec3 aPosition;

void main() { gl_Position = tiled(uProjection * (uView * vec4(aPosition, 1.0))); }
