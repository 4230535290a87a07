#version 330 core
// One triangle that covers the picture.

uniform vec4 uTile;  // scale and offset from the whole picture to the part that is drawn

out vec2 vPlace;  // 0..1 over the whole picture, bottom left first

void main() {
  vPlace = vec2((gl_VertexID & 1) * 2, (gl_VertexID >> 1) * 2);
  gl_Position = vec4((vPlace * 2.0 - 1.0) * uTile.xy + uTile.zw, 1.0, 1.0);
}
