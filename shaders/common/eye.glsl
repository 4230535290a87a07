// The eye and the size of a pixel.

uniform mat4 uView;        // model to camera
uniform mat4 uProjection;  // camera to clip space of the whole picture
uniform vec4 uTile;        // from the whole picture to the part that is drawn: scale, offset
uniform vec2 uViewport;    // size of the whole picture, pixels
uniform float uPixel;      // size of a pixel: at depth 1, or anywhere when orthographic
uniform bool uOrthographic;

vec4 tiled(vec4 clip) { return vec4(clip.xy * uTile.xy + clip.w * uTile.zw, clip.zw); }

// Clip space of a texture place, of pictures of the texture; outside where there is no place.
vec4 inTexture(vec2 place) {
  if (place.x < -1e29) return vec4(2.0, 2.0, 2.0, 1.0);
  return tiled(uProjection * vec4(place, 0.0, 1.0));
}

// Brings a point of camera space closer by so many pixels' width; its place in the picture stays.
vec3 raised(vec3 p, float pixels) {
  if (uOrthographic) return p + vec3(0.0, 0.0, pixels * uPixel);
  return p * (1.0 - min(pixels * uPixel, 0.5));
}
