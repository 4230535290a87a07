// From a value to a colour (sRGB): range, scale and steps as set for the picture.

uniform sampler2D uColorMap;  // 256 x 1
uniform vec2 uRange;          // values at both ends
uniform int uScale;           // 0 linear, 1 root, 2 logarithm
uniform int uSteps;           // number of flat steps, 0 for a smooth run

// Place of a value on the scale, in [0, 1].
float scaled(float value) {
  float width = uRange.y - uRange.x;
  if (uScale == 2) {
    float low = log(uRange.x);
    return clamp((log(max(value, uRange.x)) - low) / (log(uRange.y) - low), 0.0, 1.0);
  }
  float t = clamp((value - uRange.x) / width, 0.0, 1.0);
  return uScale == 1 ? sqrt(t) : t;
}

// Out of the range by more than rounding.
bool beyond(float value) {
  float slack = 1e-5 * (uRange.y - uRange.x);
  return value < uRange.x - slack || value > uRange.y + slack;
}

vec3 mapped(float t) {
  if (uSteps > 1) t = min(floor(t * float(uSteps)), float(uSteps - 1)) / float(uSteps - 1);
  return texture(uColorMap, vec2((t * 255.0 + 0.5) / 256.0, 0.5)).rgb;
}
