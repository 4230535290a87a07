#version 330 core
// Number of the triangle in each pixel, from 1.

uniform usamplerBuffer uLabels;
uniform samplerBuffer uChartColors;

out uint oTriangle;

void main() {
  uint chart = texelFetch(uLabels, gl_PrimitiveID).r;
  if (chart != 0xFFFFFFFFu && texelFetch(uChartColors, int(chart)).a == 0.0) discard;
  oTriangle = uint(gl_PrimitiveID) + 1u;
}
