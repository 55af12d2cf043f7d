// SPDX-License-Identifier: BSD-3-Clause
precision highp float;

out vec4 colour;

uniform vec3 groundColour;

void main() {
  colour = vec4(groundColour, 1.0);
}
