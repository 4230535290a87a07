// Patterns of marked triangles (render/surface_marks.h), in pixels of the picture: they keep their
// size and can be told apart on small triangles. Over a picture's parts they go on.

uniform usamplerBuffer uMarks;  // mark of each triangle
uniform vec3 uMarkColors[5];    // sRGB
uniform float uMarkScale;       // pixels of a pixel at 100 %
uniform vec2 uPartOrigin;       // of the part that is drawn, pixels

// 1 on a stripe, 0 between: `place` runs over a stripe and a gap with each whole number.
float stripe(float place, float pixels) {
  return clamp((0.25 - abs(fract(place) - 0.5)) * pixels + 0.5, 0.0, 1.0);
}

vec3 marked(vec3 color, uint mark) {
  if (mark == 0u) return color;
  const float period = 9.0;
  vec2 p = (gl_FragCoord.xy + uPartOrigin) / (uMarkScale * period);
  float pixels = period * uMarkScale;
  const float slope = 0.70710678;
  float on;
  if (mark == 1u) {
    on = stripe((p.x - p.y) * slope, pixels);
  } else if (mark == 2u) {
    on = max(stripe((p.x - p.y) * slope, pixels), stripe((p.x + p.y) * slope, pixels));
  } else if (mark == 3u) {
    on = stripe(p.y, pixels);
  } else {
    on = clamp((0.30 - length(fract(p) - 0.5)) * pixels + 0.5, 0.0, 1.0);
  }
  // Dark between, so that the pattern shows on any colour.
  return mix(mix(color, vec3(0.05), 0.55), uMarkColors[mark], on);
}
