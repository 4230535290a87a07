#version 330 core

uniform vec4 uBottom;  // sRGB, straight alpha
uniform vec4 uTop;

in vec2 vPlace;
out vec4 oColor;

// Breaks up the bands of a slow gradient: +- half a step of 8 bits.
float grain(vec2 pixel) { return fract(52.9829189 * fract(dot(pixel, vec2(0.06711056, 0.00583715)))); }

void main() {
  oColor = mix(uBottom, uTop, vPlace.y);
  if (uBottom != uTop) oColor.rgb += (grain(gl_FragCoord.xy) - 0.5) / 255.0;
}
