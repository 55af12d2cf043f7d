//VTK::System::Dec
// SPDX-License-Identifier: BSD-3-Clause
// Passes only where the picture is opaque.
//VTK::Output::Dec

uniform sampler2D volumeImage;
uniform float opaque;

void main()
{
  if (texelFetch(volumeImage, ivec2(gl_FragCoord.xy), 0).a < opaque)
  {
    discard;
  }
}
