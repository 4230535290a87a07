#version 330 core

uniform bool uBall;       // a seed: a ball with a dark and a light ring; else a flat disc
uniform float uRing;      // width of a ring, pixels
uniform float uOpacity;

noperspective in vec2 vPlace;
flat in float vRadius;
flat in vec3 vColor;
flat in float vEmphasis;
flat in float vLocked;
flat in float vClosed;
out vec4 oColor;

float inside(float radius, float away) { return clamp(radius + 0.5 - away, 0.0, 1.0); }

/// Distance to a padlock that fills the unit circle, negative inside.
float padlock(vec2 p) {
  vec2 side = abs(p - vec2(0.0, -0.25)) - vec2(0.5, 0.38);
  float body = length(max(side, 0.0)) + min(max(side.x, side.y), 0.0);
  vec2 bow = vec2(p.x, max(p.y - 0.2, 0.0));
  float shackle = max(abs(length(bow) - 0.33) - 0.1, -(p.y + 0.25));
  return min(body, shackle);
}

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
    if (vLocked > 0.5) {  // light with a dark rim, so that it is seen on any colour
      float lock = ball * padlock(vPlace / ball);
      rgb = mix(mix(rgb, dark, clamp(1.6 - lock, 0.0, 1.0)), light, clamp(0.5 - lock, 0.0, 1.0));
    }
    if (vClosed > 0.5 && vLocked < 0.5) {  // the bar of a closed road
      vec2 beyond = abs(vPlace / ball) - vec2(0.62, 0.2);
      float bar = ball * (length(max(beyond, 0.0)) + min(max(beyond.x, beyond.y), 0.0));
      rgb = mix(mix(rgb, dark, clamp(1.6 - bar, 0.0, 1.0)), light, clamp(0.5 - bar, 0.0, 1.0));
    }
    color = vec4(rgb, 1.0) * inside(vRadius, away);
  } else {
    vec3 rgb = mix(dark, vColor, inside(vRadius - uRing, away));
    color = vec4(rgb, 1.0) * inside(vRadius, away);
  }
  oColor = color * uOpacity;
  if (oColor.a <= 0.0) discard;
}
