// SPDX-License-Identifier: BSD-3-Clause
precision highp float;

in vec2 place;
out vec4 colour;

uniform vec3 lower;
uniform vec3 upper;

void main() {
  colour = vec4(mix(lower, upper, 0.5 * place.y + 0.5), 1.0);
}
