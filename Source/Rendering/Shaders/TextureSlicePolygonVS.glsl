//VTK::System::Dec
// SPDX-License-Identifier: BSD-3-Clause
// The corners of polygons, one polygon for each plane.
uniform mat4 boxToClip;

// Box coordinates, and the number of the plane.
in vec4 corner;
flat out float slice;

void main()
{
  slice = corner.w;
  gl_Position = boxToClip * vec4(corner.xyz, 1.0);
}
