// SPDX-License-Identifier: BSD-3-Clause
precision highp float;

in vec2 place;

out vec4 colour;

uniform sampler2D picture;

void main() {
  colour = vec4(texture(picture, place).rgb, 1.0);
}
