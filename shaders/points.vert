#version 330 core
// Round marks that face the viewer: six vertices each.
#include "common/color_map.glsl"
#include "common/eye.glsl"

uniform samplerBuffer uPoints;  // two texels each: (place, value), (sRGB colour, 1 with emphasis + 2 when locked + 4 when closed)
uniform vec2 uRadii;            // pixels, at the low and the high end of the scale
uniform bool uByValue;          // colour and size by value; else the point's own colour

noperspective out vec2 vPlace;  // pixels from the middle
flat out float vRadius;
flat out vec3 vColor;
flat out float vEmphasis;
flat out float vLocked;
flat out float vClosed;

void main() {
  int point = gl_VertexID / 6;
  int corner = gl_VertexID % 6;
  vec4 first = texelFetch(uPoints, 2 * point);
  vec4 second = texelFetch(uPoints, 2 * point + 1);
  float t = uByValue ? scaled(first.w) : 1.0;
  vRadius = mix(uRadii.x, uRadii.y, t);
  vColor = uByValue ? mapped(t) : second.rgb;
  int sign = int(second.a + 0.5);
  vLocked = (sign & 2) != 0 ? 1.0 : 0.0;
  vClosed = (sign & 4) != 0 ? 1.0 : 0.0;
  vEmphasis = (sign & 1) != 0 ? 1.0 : 0.0;
  vRadius *= 1.0 + 0.4 * vLocked;  // the padlock needs room
  int place = corner < 3 ? corner : (corner == 3 ? 2 : (corner == 4 ? 1 : 3));
  float reach = vRadius + 3.0;
  vPlace = vec2((place & 2) != 0 ? reach : -reach, (place & 1) != 0 ? reach : -reach);
  // Before the surface by its own size, so that a bulging surface does not cut it.
  vec4 clip = uProjection * vec4(raised((uView * vec4(first.xyz, 1.0)).xyz, vRadius), 1.0);
  clip.xy += vPlace / (0.5 * uViewport) * clip.w;
  gl_Position = tiled(clip);
}
