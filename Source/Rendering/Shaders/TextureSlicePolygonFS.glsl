//VTK::System::Dec
// SPDX-License-Identifier: BSD-3-Clause
// A pixel of one plane: the one sample of the pixel's ray on that plane.
//VTK::Output::Dec

flat in float slice;

//VTK::TextureSlice::Parts

void main()
{
  if (StartRay(gl_FragCoord.xy, 0.0) && slice >= raySpan.x && slice <= raySpan.y)
  {
    sampleUnits = CountSlices(slice) * length(sampleStep);
    GatherSample(PlaceAt(slice));
  }
  gl_FragData[0] = FindPicture();
}
