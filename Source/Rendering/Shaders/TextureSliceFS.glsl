//VTK::System::Dec
// SPDX-License-Identifier: BSD-3-Clause
// A pixel of the volume: its ray, from front to back.
//VTK::Output::Dec

// See vtkTextureSliceFeatures::GetDefines.
//VTK::TextureSlice::Defines

//VTK::TextureSlice::Ray
//VTK::TextureSlice::Sampling
//VTK::TextureSlice::Lighting
//VTK::TextureSlice::Shadows
//VTK::TextureSlice::Table
//VTK::TextureSlice::Coloring
//VTK::TextureSlice::Samples
//VTK::TextureSlice::Slabs
//VTK::TextureSlice::Surfaces
//VTK::TextureSlice::Skipping
//VTK::TextureSlice::March

void main()
{
  gl_FragData[0] = StartRay(gl_FragCoord.xy, TEXTURE_SLICE_LEAST_SLICES) ? March() : vec4(0.0);
}
