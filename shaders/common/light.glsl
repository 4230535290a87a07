// A calm studio that moves with the viewer: sky and ground, a key light from the upper left, a
// weaker fill from the right, a little gloss and a thin rim. All in camera space and in amounts of
// light. The eye is taken to be far away.

float square(float x) { return x * x; }

// What a unit normal receives: the colour is multiplied by xyz, w is added.
vec4 light(vec3 normal) {
  const vec3 key = vec3(-0.437, 0.632, 0.640);
  const vec3 fill = vec3(0.802, 0.115, 0.586);
  const vec3 between = vec3(-0.241, 0.349, 0.906);  // key light and eye
  float sky = 0.5 + 0.5 * normal.y;
  vec3 amount = mix(vec3(0.170, 0.160, 0.155), vec3(0.370, 0.380, 0.395), sky);
  amount += vec3(0.760, 0.745, 0.720) * max(dot(normal, key), 0.0);
  amount += vec3(0.120, 0.130, 0.145) * max(dot(normal, fill), 0.0);
  float gloss = square(square(square(square(square(max(dot(normal, between), 0.0)))))) * 0.030;
  float rim = square(square(1.0 - max(normal.z, 0.0))) * 0.10 * sky;
  return vec4(amount + 0.85 * rim, gloss + 0.15 * rim);
}
