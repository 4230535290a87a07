// A calm studio that moves with the viewer: sky and ground, a key light from the upper left, a
// weaker fill from the right and a thin rim. All in camera space and in amounts of light.

vec3 shade(vec3 albedo, vec3 normal, vec3 toEye) {
  const vec3 key = vec3(-0.437, 0.632, 0.640);
  const vec3 fill = vec3(0.802, 0.115, 0.586);
  float sky = 0.5 + 0.5 * normal.y;
  float keyAmount = max(dot(normal, key), 0.0);
  vec3 light = mix(vec3(0.170, 0.160, 0.155), vec3(0.370, 0.380, 0.395), sky);
  light += vec3(0.760, 0.745, 0.720) * keyAmount;
  light += vec3(0.120, 0.130, 0.145) * max(dot(normal, fill), 0.0);
  float gloss = pow(max(dot(normal, normalize(key + toEye)), 0.0), 48.0) * 0.030;
  float rim = pow(1.0 - max(dot(normal, toEye), 0.0), 4.0) * 0.10 * sky;
  return albedo * light + gloss + rim * (0.15 + 0.85 * albedo);
}
