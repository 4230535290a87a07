#version 330 core
#include "common/color_map.glsl"
#include "common/light.glsl"
#include "common/srgb.glsl"

const uint kNone = 0xFFFFFFFFu;

// What fills the faces.
const int kPlain = 0;
const int kCharts = 1;
const int kTriangleValue = 2;
const int kChartValue = 3;
const int kFloodTime = 4;
const int kFloodOrder = 5;
const int kChecker = 6;

uniform int uFill;
uniform vec3 uPlainColor;  // sRGB
uniform vec3 uDryColor;
uniform bool uLighting;
uniform bool uOrthographic;
uniform bool uSmoothNormals;  // false: the plane of each triangle

uniform usamplerBuffer uLabels;      // chart of each triangle
uniform usamplerBuffer uFlood;       // (order, chart) of each triangle
uniform samplerBuffer uFloodTime;    // local time of each triangle
uniform samplerBuffer uValues;       // value of each triangle
uniform samplerBuffer uChartColors;  // sRGB; alpha: 1 normal, 0.5 in the background, 0 hidden
uniform samplerBuffer uChartValues;  // (value, 1 / longest time) of each chart

uniform bool uPlay;          // show the flood up to the playhead instead of the labels
uniform uint uPlayhead;      // faces taken
uniform uint uFront;         // the newest so many are bright
uniform float uOrderScale;   // 1 / number of faces

uniform bool uWire;
uniform float uWireWidth;            // pixels
uniform samplerBuffer uVertices;     // place and packed normal of each drawn vertex
uniform usamplerBuffer uIndices;     // three vertices a triangle
uniform usamplerBuffer uInnerSides;  // bit i: side i is inside a polygon
uniform samplerBuffer uCornerUv;     // three texture places a triangle
uniform float uCheckerSquares;       // per unit of uv

uniform uint uHoverFirst;  // triangles [first, end) under the pointer
uniform uint uHoverEnd;

in vec3 vModel;
in vec3 vCamera;
in vec3 vNormal;
out vec4 oColor;

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

// Two greys in squares, smoothed over the width of a pixel (box filter of the square wave).
float checker(vec2 uv) {
  vec2 place = uv * uCheckerSquares;
  vec2 width = max(fwidth(place), vec2(1e-6));
  vec2 wave = (abs(fract((place - 0.5 * width) * 0.5) - 0.5) -
               abs(fract((place + 0.5 * width) * 0.5) - 0.5)) * 2.0 / width;
  return 0.5 - 0.5 * clamp(wave.x, -1.0, 1.0) * clamp(wave.y, -1.0, 1.0);
}

vec3 fillColor(int triangle, uint chart, uint order, vec3 weights) {
  if (uFill == kPlain) return uPlainColor;
  if (uFill == kTriangleValue) {
    float value = texelFetch(uValues, triangle).r;
    return isnan(value) ? uDryColor : mapped(scaled(value));
  }
  if (uFill == kChecker) {
    vec2 uv = weights.x * texelFetch(uCornerUv, 3 * triangle).rg +
              weights.y * texelFetch(uCornerUv, 3 * triangle + 1).rg +
              weights.z * texelFetch(uCornerUv, 3 * triangle + 2).rg;
    return mix(vec3(0.38), vec3(0.93), checker(uv));
  }
  if (chart == kNone) return uDryColor;
  if (uFill == kCharts) return texelFetch(uChartColors, int(chart)).rgb;
  if (uFill == kChartValue) return mapped(scaled(texelFetch(uChartValues, int(chart)).r));
  if (order == kNone) return uDryColor;
  float t = uFill == kFloodOrder
                ? float(order) * uOrderScale
                : texelFetch(uFloodTime, triangle).r * texelFetch(uChartValues, int(chart)).g;
  t = clamp(t, 0.0, 1.0);
  // Contour lines by alternating bands.
  float band = mod(floor(t * 20.0), 2.0);
  return mapped(t) * (1.0 - 0.10 * band);
}

void main() {
  int triangle = gl_PrimitiveID;
  uint chart = texelFetch(uLabels, triangle).r;
  uint order = kNone;
  bool flood = uPlay || uFill == kFloodTime || uFill == kFloodOrder;
  if (flood) {
    uvec2 taken = texelFetch(uFlood, triangle).rg;
    order = taken.r;
    chart = uPlay && order >= uPlayhead ? kNone : taken.g;
  }
  float presence = chart == kNone ? 1.0 : texelFetch(uChartColors, int(chart)).a;
  if (presence == 0.0) discard;

  vec3 weights = uWire || uFill == kChecker ? barycentric(triangle) : vec3(0.0);
  vec3 color = fillColor(triangle, chart, order, weights);
  bool dry = flood && chart == kNone;
  if (dry) color = uDryColor;
  if (presence < 0.75) color = mix(color, vec3(dot(color, vec3(0.3, 0.6, 0.1)) * 0.4 + 0.2), 0.75);
  if (uPlay && !dry) {
    float age = float(uPlayhead - 1u - order) / float(uFront);
    color = mix(color, vec3(1.0, 0.98, 0.90), 0.85 * clamp(1.0 - age, 0.0, 1.0));
  }
  uint id = uint(triangle);
  if (id >= uHoverFirst && id < uHoverEnd) color = mix(color, vec3(1.0), 0.45);

  if (uLighting) {
    vec3 toEye = uOrthographic ? vec3(0.0, 0.0, 1.0) : normalize(-vCamera);
    vec3 plane = normalize(cross(dFdx(vCamera), dFdy(vCamera)));
    vec3 normal = uSmoothNormals ? normalize(vNormal) : plane;
    // Insides are lit as well and a little darker.
    float back = gl_FrontFacing ? 1.0 : 0.62;
    if (dot(normal, plane) < 0.0) normal = -normal;
    color = toSrgb(clamp(shade(toLinear(color), normal, toEye) * back, 0.0, 1.0));
  }
  if (uWire) color = mix(color, vec3(0.07), 0.75 * wireCover(weights, triangle));
  oColor = vec4(color, 1.0);
}
