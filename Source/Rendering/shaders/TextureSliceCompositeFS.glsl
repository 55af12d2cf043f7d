//VTK::System::Dec
// SPDX-License-Identifier: BSD-3-Clause
// Hands the finished volume (associated colour) to the window, with the final window and level.
//VTK::Output::Dec

in vec2 texCoord;

uniform sampler2D volumeImage;
uniform float colorScale;
uniform float colorBias;

void main()
{
  vec4 color = texture(volumeImage, texCoord);
  gl_FragData[0] = vec4(color.rgb * colorScale + colorBias * color.a, color.a);
}
