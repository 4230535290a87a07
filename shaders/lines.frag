#version 330 core

noperspective in vec2 vPlace;
flat in float vLength;
flat in float vRadius;
flat in vec3 vColor;
out vec4 oColor;

void main() {
  float beyond = max(max(-vPlace.x, vPlace.x - vLength), 0.0);
  float away = length(vec2(beyond, vPlace.y));
  float core = clamp(vRadius + 0.5 - away, 0.0, 1.0);
  // Lines thinner than a pixel become fainter, not thinner.
  core *= min(2.0 * vRadius, 1.0);
  oColor = vec4(vColor, 1.0) * core;
  if (oColor.a <= 0.0) discard;
}
