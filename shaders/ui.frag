#version 330 core
// Made in variants by macros, not by uniforms: software drivers work through every branch.

uniform sampler2D uTexture;
#ifdef SIMULATE  // show pictures as the colour-blind see them
uniform mat3 uVision;  // of linear RGB
#endif

in vec2 vTexture;
in vec4 vColor;
out vec4 oColor;

#ifdef SIMULATE
vec3 toLinear(vec3 c) {
  return mix(pow((c + 0.055) / 1.055, vec3(2.4)), c / 12.92, lessThanEqual(c, vec3(0.04045)));
}

vec3 toSrgb(vec3 c) {
  return mix(1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, 12.92 * c,
             lessThanEqual(c, vec3(0.0031308)));
}
#endif

void main() {
  oColor = vColor * texture(uTexture, vTexture);
#ifdef SIMULATE
  oColor.rgb = toSrgb(clamp(uVision * toLinear(oColor.rgb), 0.0, 1.0));
#endif
}
