// SPDX-License-Identifier: BSD-3-Clause
// A rectangle of the scene: four corners.
in vec3 corner;
uniform mat4 toClip;

void main() {
  gl_Position = toClip * vec4(corner, 1.0);
  gl_Position.z = 0.0;
}
