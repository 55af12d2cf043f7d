//VTK::System::Dec
// SPDX-License-Identifier: BSD-3-Clause
// One sample of the volume, as the blend mode gathers it.
//VTK::Output::Dec

// See vtkTextureSliceFeatures::GetDefines.
//VTK::TextureSlice::Defines

in vec3 sliceCoordinate;
// Where the volume is sampled.
vec3 textureCoordinate = vec3(0.0);
// To the next slice along the ray, in the first component's unit distances.
in vec3 sampleStep;

//VTK::TextureSlice::Peel
//VTK::TextureSlice::Sampling
//VTK::TextureSlice::Lighting
//VTK::TextureSlice::Shadows
//VTK::TextureSlice::Table
#ifdef TEXTURE_SLICE_CROPPED
// The six cropping planes as texture coordinates, and one bit for each of the 27 regions between them.
uniform vec3 cropLow;
uniform vec3 cropHigh;
uniform int cropFlags;

bool IsCropped(vec3 at)
{
  ivec3 region = ivec3(greaterThanEqual(at, cropLow)) +
    ivec3(greaterThan(at, cropHigh));
  return ((cropFlags >> (region.x + 3 * region.y + 9 * region.z)) & 1) == 0;
}
#endif

// Whether cropping and mask leave what is there.
bool IsLeft(vec3 at)
{
#ifdef TEXTURE_SLICE_CROPPED
  if (IsCropped(at))
  {
    return false;
  }
#endif
#ifdef TEXTURE_SLICE_BINARY_MASK
  if (FetchLabel(at) == 0)
  {
    return false;
  }
#endif
  return true;
}

//VTK::TextureSlice::Coloring

#ifdef TEXTURE_SLICE_SLABS
//VTK::TextureSlice::Slabs
#else
#if defined TEXTURE_SLICE_EXTREME_SAMPLE && !defined TEXTURE_SLICE_PEEL
// Depth of the opaque geometry, 0 to 1.
uniform sampler2D geometryDepth;
#endif

// Whether the sample is in front of the opaque geometry, or within the part of a peel.
bool IsInSight()
{
#ifdef TEXTURE_SLICE_PEEL
  return IsInPeel(gl_FragCoord.z);
#elif defined TEXTURE_SLICE_EXTREME_SAMPLE
  return gl_FragCoord.z <= texelFetch(geometryDepth, ivec2(gl_FragCoord.xy), 0).r;
#else
  return true; // the depth test decides
#endif
}

bool GatherSample(out vec4 gathered)
{
  textureCoordinate = sliceCoordinate;
  if (!IsInSight())
  {
    return false;
  }
#if TEXTURE_SLICE_BLEND != TEXTURE_SLICE_ISOSURFACE
  // A surface lies beside the sample.
  if (!IsLeft(textureCoordinate))
  {
    return false;
  }
#endif
  vec4 scalars;
  return FetchScalars(textureCoordinate, scalars) && Gather(scalars, gathered);
}
#endif

void main()
{
#ifdef TEXTURE_SLICE_SLABS
  Slab slabs[TEXTURE_SLICE_SLABS];
  if (!MakeSlabs(slabs))
  {
    discard;
  }
  gl_FragData[0] = GatherSlabs(slabs);
#else
  vec4 gathered;
  if (!GatherSample(gathered))
  {
    discard;
  }
  gl_FragData[0] = gathered;
#ifdef TEXTURE_SLICE_EXTREME_SAMPLE
  gl_FragDepth = ExtremeDepth(gathered);
#endif
#endif
}
