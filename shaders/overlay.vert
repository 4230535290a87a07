#version 330 core
// Text and plain shapes in pixels, origin at the top left.

layout(location = 0) in vec2 aPlace;
layout(location = 1) in vec2 aTexture;
layout(location = 2) in vec4 aColor;
layout(location = 3) in vec4 aHalo;
layout(location = 4) in float aKind;

uniform vec2 uViewport;
uniform vec4 uTile;

out vec2 vTexture;
out vec4 vColor;
out vec4 vHalo;
flat out float vKind;

void main() {
  vTexture = aTexture;
  vColor = aColor;
  vHalo = aHalo;
  vKind = aKind;
  vec2 ndc = vec2(aPlace.x / uViewport.x * 2.0 - 1.0, 1.0 - aPlace.y / uViewport.y * 2.0);
  gl_Position = vec4(ndc * uTile.xy + uTile.zw, 0.0, 1.0);
}
