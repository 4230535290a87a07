#version 330 core

uniform bool uBall;       // a seed: a ball with a dark and a light ring; else a flat disc
uniform float uRing;      // width of a ring, pixels
uniform float uOpacity;

noperspective in vec2 vPlace;
flat in float vRadius;
flat in vec3 vColor;
flat in float vEmphasis;
out vec4 oColor;

float inside(float radius, float away) { return clamp(radius + 0.5 - away, 0.0, 1.0); }

void main() {
  float away = length(vPlace);
  const vec3 dark = vec3(0.06);
  const vec3 light = vec3(0.97);
  vec4 color;
  if (uBall) {
    float ball = vRadius - 2.0 * uRing;
    vec3 normal = vec3(vPlace, sqrt(max(ball * ball - away * away, 0.0))) / max(ball, 1e-3);
    float lit = 0.62 + 0.42 * max(dot(normal, vec3(-0.45, 0.60, 0.66)), 0.0);
    vec3 core = vColor * lit + 0.5 * pow(max(dot(normal, vec3(-0.25, 0.33, 0.91)), 0.0), 24.0);
    vec3 ring = mix(light, vec3(1.0, 0.85, 0.1), vEmphasis);
    vec3 rgb = mix(mix(dark, ring, inside(vRadius - uRing, away)), min(core, 1.0), inside(ball, away));
    color = vec4(rgb, 1.0) * inside(vRadius, away);
  } else {
    vec3 rgb = mix(dark, vColor, inside(vRadius - uRing, away));
    color = vec4(rgb, 1.0) * inside(vRadius, away);
  }
  oColor = color * uOpacity;
  if (oColor.a <= 0.0) discard;
}
