#version 330 core

uniform sampler2D uTexture;

in vec2 vTexture;
in vec4 vColor;
out vec4 oColor;

void main() { oColor = vColor * texture(uTexture, vTexture); }
