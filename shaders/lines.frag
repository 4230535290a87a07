#version 330 core

uniform float uCasing;
uniform vec4 uCasingColor;  // sRGB, straight alpha
uniform float uOpacity;

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
  float edge = uCasing > 0.0 ? clamp(vRadius + uCasing + 0.5 - away, 0.0, 1.0) : 0.0;
  vec4 casing = vec4(uCasingColor.rgb, 1.0) * (uCasingColor.a * edge);
  oColor = (vec4(vColor, 1.0) * core + casing * (1.0 - core)) * uOpacity;
  if (oColor.a <= 0.0) discard;
}
