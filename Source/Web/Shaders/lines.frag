// SPDX-License-Identifier: BSD-3-Clause
precision highp float;

in float beside;
out vec4 colour;

uniform vec3 lineColour;
uniform float lineWidth;

void main() {
  float covered = clamp(0.5 * lineWidth + 0.5 - abs(beside), 0.0, 1.0);
  colour = vec4(lineColour, 1.0) * min(covered, lineWidth);
}
