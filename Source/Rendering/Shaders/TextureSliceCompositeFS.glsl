//VTK::System::Dec
// SPDX-License-Identifier: BSD-3-Clause
// Hands the finished volume (associated colour) to the window, with the final window and level.
//VTK::Output::Dec

// See vtkTextureSliceFeatures::GetDefines.
//VTK::TextureSlice::Defines

in vec2 texCoord;

uniform sampler2D volumeImage;
uniform float colorScale;
uniform float colorBias;

#if TEXTURE_SLICE_BLEND == TEXTURE_SLICE_MAXIMUM || TEXTURE_SLICE_BLEND == TEXTURE_SLICE_MINIMUM
//VTK::TextureSlice::Table
uniform float componentWeight[TEXTURE_SLICE_COMPONENTS];

// The picture holds the extremes of the scalars (0 to 1); where there are no samples, what it was
// cleared with.
vec4 PictureColor(vec4 extremes)
{
  if (extremes.x < -0.5 || extremes.x > 1.5)
  {
    return vec4(0.0);
  }
#ifdef TEXTURE_SLICE_EXTREME_SAMPLE
#if TEXTURE_SLICE_COMPONENTS == 2
  vec4 color = vec4(LookUp(extremes.x, 0).rgb, LookUp(extremes.y, 0).a);
#else
  vec4 color = vec4(clamp(extremes.rgb, 0.0, 1.0), LookUp(extremes.a, 0).a);
#endif
  return vec4(color.rgb * color.a, color.a);
#else
  vec4 sum = vec4(0.0);
  for (int i = 0; i < TEXTURE_SLICE_COMPONENTS; ++i)
  {
    vec4 color = LookUp(extremes[i], i);
    sum += componentWeight[i] * vec4(color.rgb * color.a, color.a);
  }
  return sum;
#endif
}
#elif TEXTURE_SLICE_BLEND == TEXTURE_SLICE_ADDITIVE || TEXTURE_SLICE_BLEND == TEXTURE_SLICE_AVERAGE
// Red holds a sum, alpha the number of samples.
vec4 PictureColor(vec4 sums)
{
  if (sums.a <= 0.0)
  {
    return vec4(0.0);
  }
#if TEXTURE_SLICE_BLEND == TEXTURE_SLICE_AVERAGE
  sums.r /= sums.a;
#endif
  return vec4(vec3(clamp(sums.r, 0.0, 1.0)), 1.0);
}
#else
vec4 PictureColor(vec4 blended)
{
  return blended;
}
#endif

#ifdef TEXTURE_SLICE_SELECTION
uniform vec3 selectionColor;

void main()
{
  // As in VTK's ray caster, what is fainter cannot be picked.
  if (PictureColor(texture(volumeImage, texCoord)).a <= 3.0 / 255.0)
  {
    discard;
  }
  gl_FragData[0] = vec4(selectionColor, 1.0);
}
#else
// With the final window and level.
vec4 FinalColor()
{
  vec4 color = PictureColor(texture(volumeImage, texCoord));
  return vec4(color.rgb * colorScale + colorBias * color.a, color.a);
}

#ifdef TEXTURE_SLICE_PEEL
//VTK::TextureSlice::Peel
//VTK::TextureSlice::PeelComposite
#else
void main()
{
  gl_FragData[0] = FinalColor();
}
#endif
#endif
