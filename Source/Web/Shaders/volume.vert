// SPDX-License-Identifier: BSD-3-Clause
// A triangle over the whole picture; `place` is -1 to 1 in both directions.
out vec2 place;

void main() {
  place = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
  gl_Position = vec4(place, 0.0, 1.0);
}
