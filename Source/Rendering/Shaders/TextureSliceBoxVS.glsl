//VTK::System::Dec
// SPDX-License-Identifier: BSD-3-Clause
// The twelve triangles of a box, without vertices in memory. Of its faces those turned away from the eye
// cover each pixel of the box once, wherever the eye is.
uniform mat4 boxToClip;
// In box coordinates.
uniform vec3 seenLow;
uniform vec3 seenHigh;
// Where the box is drawn once a plane: the number of the plane.
flat out float slice;

// A corner has one bit for each axis. The two triangles of each face turn the same way as seen from outside.
const int corners[36] = int[36](0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4, 2, 6, 3, 3, 6, 7, 0, 4,
  2, 2, 4, 6, 1, 3, 5, 3, 7, 5);

void main()
{
  slice = float(gl_InstanceID);
  int corner = corners[gl_VertexID];
  vec3 side = vec3(ivec3(corner, corner >> 1, corner >> 2) & 1);
  gl_Position = boxToClip * vec4(mix(seenLow, seenHigh, side), 1.0);
}
