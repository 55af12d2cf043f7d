// SPDX-License-Identifier: BSD-3-Clause
// A rectangle of the scene: four corners.
in vec3 corner;
uniform mat4 toClip;

out vec2 place; // in the picture of the ground

void main() {
  place = vec2(gl_VertexID & 1, gl_VertexID >> 1);
  gl_Position = toClip * vec4(corner, 1.0);
  gl_Position.z = 0.0;
}
