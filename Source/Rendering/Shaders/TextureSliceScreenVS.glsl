//VTK::System::Dec
// SPDX-License-Identifier: BSD-3-Clause
// One triangle that covers the viewport, without vertices in memory.
out vec2 texCoord;

void main()
{
  texCoord = vec2((gl_VertexID << 1) & 2, gl_VertexID & 2);
  gl_Position = vec4(2.0 * texCoord - 1.0, 0.0, 1.0);
}
