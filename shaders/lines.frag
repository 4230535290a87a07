#version 330 core

noperspective in vec2 vPlace;
flat in float vLength;
flat in float vRadius;
flat in vec3 vColor;
flat in vec2 vEnds;

uniform float uDash;  // value over a dash and a gap; 0: a whole line
out vec4 oColor;

void main() {
  float beyond = max(max(-vPlace.x, vPlace.x - vLength), 0.0);
  float away = length(vec2(beyond, vPlace.y));
  float core = clamp(vRadius + 0.5 - away, 0.0, 1.0);
  // Lines thinner than a pixel become fainter, not thinner.
  core *= min(2.0 * vRadius, 1.0);
  if (uDash > 0.0) {
    float value = mix(vEnds.x, vEnds.y, clamp(vPlace.x / max(vLength, 1e-4), 0.0, 1.0));
    float pixels = vLength / max(abs(vEnds.y - vEnds.x), 1e-9);  // of a unit of the value
    float inside = (0.31 - abs(fract(value / uDash) - 0.5)) * uDash * pixels;
    core *= clamp(inside + 0.5, 0.0, 1.0);
  }
  oColor = vec4(vColor, 1.0) * core;
  if (oColor.a <= 0.0) discard;
}
