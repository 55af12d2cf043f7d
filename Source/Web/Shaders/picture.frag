// SPDX-License-Identifier: BSD-3-Clause
// The picture of the volume, which may have fewer pixels, over what is drawn behind it.
precision highp float;

in vec2 place;
out vec4 colour;

uniform sampler2D picture;
uniform vec2 used; // share of the texture that holds the picture

void main() {
  vec2 limit = used - 0.5 / vec2(textureSize(picture, 0));
  colour = texture(picture, min((0.5 * place + 0.5) * used, limit));
}
