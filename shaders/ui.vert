#version 330 core
// The interface: textured triangles in pixels, origin at the top left.

layout(location = 0) in vec2 aPlace;
layout(location = 1) in vec2 aTexture;
layout(location = 2) in vec4 aColor;

uniform vec2 uOrigin;
uniform vec2 uSize;

out vec2 vTexture;
out vec4 vColor;

void main() {
  vTexture = aTexture;
  vColor = aColor;
  vec2 place = (aPlace - uOrigin) / uSize;
  gl_Position = vec4(place.x * 2.0 - 1.0, 1.0 - place.y * 2.0, 0.0, 1.0);
}
