#version 330 core
// Made in variants by macros, not by uniforms: software drivers work through every branch.
//   FILL          what fills the faces: one of FILL_PLAIN, .., which the program defines
//   FLOOD         the recorded flood decides which chart a face has; with PLAY up to the playhead
//   STATES        charts may be hidden or step back
//   LIGHT         light and shadow; with FLAT each triangle is shaded by its plane, with
//                 VERTEX_LIGHT by what its corners receive
//   WIRE          mesh edges: corners' places are looked up
//   CHECKER 0..2  what stands on the checkerboard, with its FILL
//   MARKS         some triangles carry a pattern
//   IN_TEXTURE    triangles stand where the texture has them
//   SIMPLE        each triangle that is drawn stands for one of many
#include "common/color_map.glsl"
#include "common/light.glsl"

const uint kNone = 0xFFFFFFFFu;

#if FILL == FILL_CHECKER
#include "common/checker.glsl"
in vec2 vChecker;  // squares; far below 0: no place in the texture
#endif
#ifdef MARKS
#include "common/marks.glsl"
#endif

uniform vec3 uPlainColor;  // sRGB
uniform vec3 uDryColor;
uniform bool uClamp;  // values out of the range have its end colours, else the dry one

uniform usamplerBuffer uLabels;      // chart of each triangle
uniform usamplerBuffer uFlood;       // (order, chart) of each triangle
uniform samplerBuffer uFloodTime;    // local time of each triangle
uniform samplerBuffer uValues;       // value of each triangle
uniform samplerBuffer uChartColors;  // sRGB; alpha: 1 normal, 0.5 in the background, 0 hidden
uniform samplerBuffer uChartValues;  // (value, 1 / longest time) of each chart

uniform uint uPlayhead;      // faces taken
uniform uint uFront;         // the newest so many are bright
uniform float uOrderScale;   // 1 / number of faces

uniform float uWireWidth;            // pixels
uniform samplerBuffer uVertices;     // place and packed normal of each drawn vertex
uniform usamplerBuffer uIndices;     // three vertices a triangle
uniform usamplerBuffer uInnerSides;  // bit i: side i is inside a polygon

uniform int uFirstTriangle;  // of the part that is drawn
#ifdef SIMPLE
uniform usamplerBuffer uTriangles;  // of the mesh, for each triangle that is drawn
#endif

uniform uint uHoverFirst;  // triangles [first, end) under the pointer
uniform uint uHoverEnd;
uniform uint uFlashFirst;            // triangles that a step has just taken
uniform uint uFlashEnd;
uniform uint uHoverChart;  // the chart under the pointer

#ifdef WIRE
in vec3 vModel;
#endif
#ifdef FLAT
in vec3 vCamera;
#elif defined(VERTEX_LIGHT)
in vec4 vLight;
#else
in vec3 vNormal;
#endif
out vec4 oColor;

#ifdef WIRE
// Weights of the triangle's corners at this place.
vec3 barycentric(int triangle) {
  vec3 a = texelFetch(uVertices, int(texelFetch(uIndices, 3 * triangle).r)).xyz;
  vec3 b = texelFetch(uVertices, int(texelFetch(uIndices, 3 * triangle + 1).r)).xyz;
  vec3 c = texelFetch(uVertices, int(texelFetch(uIndices, 3 * triangle + 2).r)).xyz;
  vec3 n = cross(b - a, c - a);
  float whole = max(dot(n, n), 1e-30);
  float atB = dot(cross(vModel - a, c - a), n) / whole;
  float atC = dot(cross(b - a, vModel - a), n) / whole;
  return vec3(1.0 - atB - atC, atB, atC);
}

// How much of a mesh edge covers this pixel. Edges of triangles of a few pixels fade away: they
// would only darken the model.
float wireCover(vec3 weights, int triangle) {
  vec3 slope = max(fwidth(weights), vec3(1e-6));
  vec3 pixels = weights.zxy / slope.zxy;  // distance from sides 0-1, 1-2, 2-0
  uint inner = texelFetch(uInnerSides, triangle).r;
  for (int i = 0; i < 3; ++i) {
    if ((inner & (1u << i)) != 0u) pixels[i] = 1e6;
  }
  float nearest = min(min(pixels.x, pixels.y), pixels.z);
  float cover = 1.0 - smoothstep(0.5 * uWireWidth - 0.5, 0.5 * uWireWidth + 0.7, nearest);
  float size = 1.0 / max(max(slope.x, slope.y), slope.z);
  return cover * smoothstep(2.5, 9.0, size);
}
#endif

vec3 fillColor(int triangle, uint chart, uint order) {
#if FILL == FILL_PLAIN
  return uPlainColor;
#elif FILL == FILL_TRIANGLE_VALUE
  float value = texelFetch(uValues, triangle).r;
  return isnan(value) || (!uClamp && beyond(value)) ? uDryColor : mapped(scaled(value));
#elif FILL == FILL_CHECKER
  if (vChecker.x < -1e20) return uDryColor;
  vec3 tint = chart == kNone ? vec3(0.6) : texelFetch(uChartColors, int(chart)).rgb;
  return checkerColor(vChecker, tint);
#else
  if (chart == kNone) return uDryColor;
#if FILL == FILL_CHARTS
  return texelFetch(uChartColors, int(chart)).rgb;
#elif FILL == FILL_CHART_VALUE
  float value = texelFetch(uChartValues, int(chart)).r;
  return !uClamp && beyond(value) ? uDryColor : mapped(scaled(value));
#else
#if FILL == FILL_FLOOD_ORDER
  float t = float(order) * uOrderScale;
#else
  float t = texelFetch(uFloodTime, triangle).r * texelFetch(uChartValues, int(chart)).g;
#endif
  t = clamp(t, 0.0, 1.0);
  // Contour lines by alternating bands.
  float band = mod(floor(t * 20.0), 2.0);
  return mapped(t) * (1.0 - 0.10 * band);
#endif
#endif
}

// sRGB in, sRGB out. Squares and roots stand for the sRGB curve: they differ by less than the eye
// sees here and cost far less.
vec3 lit(vec3 color) {
#if defined(VERTEX_LIGHT)
  vec4 amount = vLight;
#else
#if defined(FLAT)
  vec3 normal = normalize(cross(dFdx(vCamera), dFdy(vCamera)));
#else
  vec3 normal = normalize(gl_FrontFacing ? vNormal : -vNormal);
#endif
  // Insides are lit as well and a little darker.
  vec4 amount = light(normal) * (gl_FrontFacing ? 1.0 : 0.62);
#endif
  return sqrt(clamp(color * color * amount.rgb + amount.a, 0.0, 1.0));
}

void main() {
  int triangle = gl_PrimitiveID + uFirstTriangle;
#ifdef SIMPLE
  triangle = int(texelFetch(uTriangles, triangle).r);
#endif
#ifdef FLOOD
  uvec2 taken = texelFetch(uFlood, triangle).rg;
  uint order = taken.r;
  uint chart = taken.g;
#ifdef PLAY
  if (order >= uPlayhead) chart = kNone;
#endif
#else
  uint order = kNone;
  uint chart = texelFetch(uLabels, triangle).r;
#endif
#ifdef STATES
  float presence = chart == kNone ? 1.0 : texelFetch(uChartColors, int(chart)).a;
  if (presence == 0.0) discard;
#endif
  vec3 color = fillColor(triangle, chart, order);
#ifdef FLOOD
  if (chart == kNone) color = uDryColor;
#endif
#ifdef STATES
  if (presence < 0.75) color = mix(color, vec3(dot(color, vec3(0.3, 0.6, 0.1)) * 0.4 + 0.2), 0.75);
#endif
#ifdef PLAY
  float age = float(uPlayhead - 1u - order) / float(max(uFront, 1u));
  float front = chart == kNone || uFront == 0u ? 0.0 : 0.85 * clamp(1.0 - age, 0.0, 1.0);
  color = mix(color, vec3(1.0, 0.98, 0.90), front);
#endif
  uint id = uint(triangle);
  float hover = chart != kNone && chart == uHoverChart ? 0.14 : 0.0;
  if (id >= uHoverFirst && id < uHoverEnd) hover = 0.5;
  color = mix(color, vec3(1.0), hover);
  if (id >= uFlashFirst && id < uFlashEnd) color = vec3(1.0, 0.80, 0.10);
#ifdef LIGHT
  color = lit(color);
#endif
#ifdef MARKS
  color = marked(color, texelFetch(uMarks, triangle).r);
#endif
#ifdef WIRE
  color = mix(color, vec3(0.07), 0.75 * wireCover(barycentric(triangle), triangle));
#endif
  oColor = vec4(color, 1.0);
}
