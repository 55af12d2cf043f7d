//VTK::System::Dec
// SPDX-License-Identifier: BSD-3-Clause
// One sample of the volume: its colour, associated with the opacity of one step along this ray.
//VTK::Output::Dec

// Defined by the mapper: TEXTURE_SLICE_MASKED, TEXTURE_SLICE_CROPPED.
//VTK::TextureSlice::Defines

in vec3 textureCoordinate;
in vec3 sampleStep;

uniform sampler3D volumeTexture;
uniform sampler2D transferTable;

// From a texel to the centre of its entry in the table.
uniform float tableScale;
uniform float tableBias;
uniform float inverseUnitDistance;

#ifdef TEXTURE_SLICE_CROPPED
// The six cropping planes as texture coordinates, and one bit for each of the 27 regions between them.
uniform vec3 cropLow;
uniform vec3 cropHigh;
uniform int cropFlags;

bool IsCropped()
{
  ivec3 region = ivec3(greaterThanEqual(textureCoordinate, cropLow)) +
    ivec3(greaterThan(textureCoordinate, cropHigh));
  return ((cropFlags >> (region.x + 3 * region.y + 9 * region.z)) & 1) == 0;
}
#endif

void main()
{
#ifdef TEXTURE_SLICE_CROPPED
  if (IsCropped())
  {
    discard;
  }
#endif

#ifdef TEXTURE_SLICE_MASKED
  // Green is 1 at visible points and 0 at hidden ones, where red is 0 too. Their quotient is the
  // mean of the visible points alone; where the hidden ones weigh more, there is nothing to see.
  vec2 texel = texture(volumeTexture, textureCoordinate).rg;
  if (texel.g < 0.5)
  {
    discard;
  }
  float scalar = texel.r / texel.g;
#else
  float scalar = texture(volumeTexture, textureCoordinate).r;
#endif

  vec4 color = texture(transferTable, vec2(scalar * tableScale + tableBias, 0.5));
  if (color.a <= 0.0)
  {
    discard;
  }
  // Formulas R1: the opacity of a step is that of a unit distance to the power of their ratio.
  float opacity = 1.0 - pow(1.0 - color.a, length(sampleStep) * inverseUnitDistance);
  gl_FragData[0] = vec4(color.rgb * opacity, opacity);
}
