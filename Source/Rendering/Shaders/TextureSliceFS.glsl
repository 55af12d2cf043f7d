//VTK::System::Dec
// SPDX-License-Identifier: BSD-3-Clause
// A pixel of the volume: its ray, from front to back.
//VTK::Output::Dec

//VTK::TextureSlice::Parts

void main()
{
  gl_FragData[0] = StartRay(gl_FragCoord.xy, TEXTURE_SLICE_LEAST_SLICES) ? March() : vec4(0.0);
}
