#version 330 core

uniform sampler2D uGlyphs;    // signed distance to the outline of each letter
uniform sampler2D uColorMap;
uniform float uDistanceUnit;  // pixels of the glyph picture over the whole range of distances
uniform int uSteps;

in vec2 vTexture;
in vec4 vColor;
in vec4 vHalo;
flat in float vKind;  // 0 plain, 1 letter, 2 colour bar
out vec4 oColor;

void main() {
  if (vKind > 1.5) {
    float t = vTexture.y;
    if (uSteps > 1) t = min(floor(t * float(uSteps)), float(uSteps - 1)) / float(uSteps - 1);
    oColor = vec4(texture(uColorMap, vec2((t * 255.0 + 0.5) / 256.0, 0.5)).rgb, 1.0);
    return;
  }
  if (vKind < 0.5) {
    oColor = vec4(vColor.rgb * vColor.a, vColor.a);
    return;
  }
  // Distance from the outline in pixels of the picture: positive inside.
  vec2 texels = vec2(textureSize(uGlyphs, 0));
  float enlarge = 1.0 / max(length(fwidth(vTexture * texels)) * 0.7071, 1e-4);
  float away = (texture(uGlyphs, vTexture).r - 0.5) * uDistanceUnit * enlarge;
  float letter = clamp(away + 0.5, 0.0, 1.0) * vColor.a;
  // Small letters have small distances: the halo must end before they do.
  float reach = min(2.6, 0.46 * uDistanceUnit * enlarge);
  float halo = smoothstep(-reach, -0.15 * reach, away) * vHalo.a;
  vec4 under = vec4(vHalo.rgb, 1.0) * halo;
  oColor = vec4(vColor.rgb, 1.0) * letter + under * (1.0 - letter);
  if (oColor.a <= 0.0) discard;
}
