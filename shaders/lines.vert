#version 330 core
// Thick lines: six vertices a segment, no vertex data but the array of segments.
#include "common/color_map.glsl"
#include "common/eye.glsl"

uniform samplerBuffer uSegments;  // two texels each: (start, value), (end, value)
uniform int uFirst;
uniform vec2 uWidths;    // pixels, at the low and the high end of the scale; equal: no scale
uniform vec4 uColor;     // sRGB; alpha 0: colour by value

uniform bool uByCharts;  // values are charts: without those between two hidden ones
uniform samplerBuffer uChartColors;

noperspective out vec2 vPlace;  // along and across the segment, pixels
flat out float vLength;
flat out float vRadius;
flat out vec3 vColor;
flat out vec2 vEnds;  // values at both ends, for dashes

const float kNear = 1e-4;

void main() {
  int segment = uFirst + gl_VertexID / 6;
  int corner = gl_VertexID % 6;
  vec4 first = texelFetch(uSegments, 2 * segment);
  vec4 second = texelFetch(uSegments, 2 * segment + 1);
  vec3 a = (uView * vec4(first.xyz, 1.0)).xyz;
  vec3 b = (uView * vec4(second.xyz, 1.0)).xyz;
  vEnds = vec2(first.w, second.w);
  if (uByCharts && texelFetch(uChartColors, int(first.w)).a == 0.0 &&
      texelFetch(uChartColors, int(second.w)).a == 0.0) {
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
    return;
  }
  float t = scaled(first.w);
  vRadius = 0.5 * mix(uWidths.x, uWidths.y, t);
  vColor = uColor.a == 0.0 ? mapped(t) : uColor.rgb;

  if (!uOrthographic) {  // keep only what lies before the eye
    if (a.z > -kNear && b.z > -kNear) {
      gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
      return;
    }
    if (a.z > -kNear) a = mix(a, b, (a.z + kNear) / (a.z - b.z));
    if (b.z > -kNear) b = mix(b, a, (b.z + kNear) / (b.z - a.z));
  }
  float lift = 2.4 * max(vRadius, 0.5);  // before the surface, so that it does not cut the line
  vec4 clipA = uProjection * vec4(raised(a, lift), 1.0);
  vec4 clipB = uProjection * vec4(raised(b, lift), 1.0);
  vec2 screenA = 0.5 * uViewport * clipA.xy / clipA.w;
  vec2 screenB = 0.5 * uViewport * clipB.xy / clipB.w;
  vec2 along = screenB - screenA;
  vLength = length(along);
  along = vLength > 1e-4 ? along / vLength : vec2(1.0, 0.0);
  vec2 across = vec2(-along.y, along.x);

  // Corners 0 1 2, 2 1 3 of the rectangle around the line; half a pixel more for its smooth edge.
  int place = corner < 3 ? corner : (corner == 3 ? 2 : (corner == 4 ? 1 : 3));
  bool atEnd = place >= 2;
  float reach = vRadius + 1.0;
  float sideways = (place & 1) == 0 ? -reach : reach;
  vPlace = vec2(atEnd ? vLength + reach : -reach, sideways);
  vec4 clip = atEnd ? clipB : clipA;
  vec2 screen = screenA + along * vPlace.x + across * vPlace.y;
  clip.xy = screen / (0.5 * uViewport) * clip.w;
  gl_Position = tiled(clip);
}
