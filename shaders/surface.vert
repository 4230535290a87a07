#version 330 core
// Variants as in surface.frag; every value handed on costs time for every triangle.
#include "common/eye.glsl"
#include "common/light.glsl"

layout(location = 0) in vec3 aPosition;
layout(location = 1) in vec4 aNormal;
layout(location = 2) in vec3 aTexture;  // place, then normalised units per texture unit

uniform float uOutside;  // -1 for a closed surface whose triangles face inwards

#ifdef CHECKER
uniform float uCheckerSquares;   // per normalised unit, or per texture unit
uniform bool uCheckerInTexture;  // per texture unit
out vec2 vChecker;
#endif

#ifdef WIRE
out vec3 vModel;  // place in model space
#endif
#ifdef FLAT
out vec3 vCamera;  // place in camera space
#elif defined(VERTEX_LIGHT)
out vec4 vLight;  // factor of the colour; addition
#else
out vec3 vNormal;  // camera space, not of unit length
#endif

void main() {
  vec3 camera = (uView * vec4(aPosition, 1.0)).xyz;
#ifdef WIRE
  vModel = aPosition;
#endif
#ifdef FLAT
  vCamera = camera;
#elif defined(VERTEX_LIGHT)
  vLight = light(normalize(mat3(uView) * aNormal.xyz * uOutside));
#else
  vNormal = mat3(uView) * aNormal.xyz * uOutside;
#endif
#ifdef CHECKER
  vChecker = aTexture.xy;
  if (aTexture.x > -1e29) vChecker *= uCheckerSquares * (uCheckerInTexture ? 1.0 : aTexture.z);
#endif
#ifdef IN_TEXTURE
  gl_Position = inTexture(aTexture.xy);
#else
  gl_Position = tiled(uProjection * vec4(camera, 1.0));
#endif
}
