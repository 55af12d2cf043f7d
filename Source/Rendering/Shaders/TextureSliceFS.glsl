//VTK::System::Dec
// SPDX-License-Identifier: BSD-3-Clause
// A pixel of the volume: its ray, from front to back; of a polygon, the one sample of the ray on the plane, or all
// samples of a ray that has slices of its own.
//VTK::Output::Dec

// The number of the plane.
flat in float slice;

//VTK::TextureSlice::Parts

void main()
{
#ifdef TEXTURE_SLICE_POLYGONS
  bool isDrawn = StartRay(gl_FragCoord.xy);
  if (isDrawn && slice == ownPlane)
  {
    picture = March();
  }
  else if (isDrawn && ownPlane < 0.0 && slice >= raySpan.x && slice <= raySpan.y)
  {
    sampleUnits = CountSlices(slice) * length(sampleStep);
    GatherSample(slice);
    EndTurn();
  }
  gl_FragData[0] = FindPicture();
#else
  gl_FragData[0] = StartRay(gl_FragCoord.xy) ? March() : vec4(0.0);
#endif
}
