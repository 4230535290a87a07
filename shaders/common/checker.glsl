// The checkerboard, smoothed over the width of a pixel. CHECKER 0: squares, 1: squares with a
// letter for the column and a digit for the row, 2: discs, 3: a picture.

#ifndef CHECKER
#define CHECKER 0
#endif

uniform float uCheckerTint;  // 0: greys, 1: the chart's colour

// The square wave of period 2 that is 1 in [0, 1) and -1 in [1, 2), averaged over `width`.
vec2 squareWave(vec2 place, vec2 width) {
  vec2 left = abs(fract((place - 0.5 * width) * 0.5) - 0.5);
  vec2 right = abs(fract((place + 0.5 * width) * 0.5) - 0.5);
  return (left - right) * 2.0 / width;
}

#if CHECKER == 1
uniform sampler2D uGlyphs;             // signed distance to the outline of each letter
uniform samplerBuffer uCheckerGlyphs;  // two texels each: place in uGlyphs; width, height, top
uniform float uGlyphUnit;              // ems over the whole range of distances

// How much of a pixel of this width is covered by the cell's letter and digit.
float letters(vec2 cell, vec2 inside, float width) {
  const float em = 0.60;  // of a cell
  bool right = inside.x >= 0.5;
  float number = mod(right ? cell.y : cell.x, right ? 10.0 : 26.0);
  int glyph = 2 * (int(number + 0.5) + (right ? 26 : 0));
  vec4 box = texelFetch(uCheckerGlyphs, glyph);
  vec3 size = texelFetch(uCheckerGlyphs, glyph + 1).xyz;
  vec2 place = vec2(inside.x - (right ? 0.70 : 0.31), 0.28 - inside.y) / em;  // from the baseline
  place = vec2(place.x / size.x + 0.5, (place.y - size.z) / size.y);
  vec2 limited = clamp(place, 0.0, 1.0);
  if (limited != place) return 0.0;
  float away = (textureLod(uGlyphs, mix(box.xy, box.zw, place), 0.0).r - 0.5) * uGlyphUnit * em;
  return clamp(away / width + 0.5, 0.0, 1.0);
}
#endif

// 0 dark, 1 light. What is finer than a pixel fades to the mean, before it would flicker.
float checkerLight(vec2 place) {
  vec2 alongX = dFdx(place), alongY = dFdy(place);
  vec2 width = max(abs(alongX) + abs(alongY), vec2(1e-6));
  float widest = max(width.x, width.y);
  float seen = 1.0 - smoothstep(0.55, 1.0, widest);
  vec2 cell = floor(place);
  vec2 inside = place - cell;
#if CHECKER == 2
  const float radius = 0.36;
  vec2 fromMiddle = inside - 0.5;
  float away = length(fromMiddle);
  vec2 outwards = fromMiddle / max(away, 1e-6);
  float pixel = length(vec2(dot(outwards, alongX), dot(outwards, alongY)));
  float disc = clamp((radius - away) / max(pixel, 1e-6) + 0.5, 0.0, 1.0);
  return 1.0 - mix(3.14159 * radius * radius, disc, 1.0 - smoothstep(0.35, 0.7, widest));
#else
  vec2 wave = clamp(squareWave(place, width), -1.0, 1.0);
  float light = 0.5 - 0.5 * wave.x * wave.y * seen;
#if CHECKER == 1
  float cover = letters(cell, inside, 0.75 * widest) * (1.0 - smoothstep(0.06, 0.12, widest));
  light = mix(light, light > 0.5 ? 0.16 : 0.92, cover);
#endif
  return light;
#endif
}

#if CHECKER == 3
uniform sampler2D uCheckerPicture;  // premultiplied by alpha
#endif

vec3 checkerColor(vec2 place, vec3 chart) {
#if CHECKER == 3
  vec4 texel = texture(uCheckerPicture, place);
  return texel.rgb + (1.0 - texel.a) * vec3(0.6);
#endif
  vec3 dark = mix(vec3(0.36), 0.62 * chart, uCheckerTint);
  vec3 light = mix(vec3(0.92), mix(vec3(1.0), chart, 0.45), uCheckerTint);
  return mix(dark, light, checkerLight(place));
}
