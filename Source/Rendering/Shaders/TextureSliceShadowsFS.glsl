// What of the light arrives at a sample.
#ifdef TEXTURE_SLICE_SHADOWS

// Red: the transmittance to the light. Green: its mean over the sky (Formulas L2).
uniform sampler3D lightTexture;
// From the volume's texture coordinates to those of the light.
uniform vec3 lightTextureScale;
// How strong shadow and occlusion are, 0 to 1.
uniform vec2 lightStrength;

// Of the light, and of the sky's.
vec2 FetchArriving()
{
  return mix(
    vec2(1.0), texture(lightTexture, textureCoordinate * lightTextureScale).rg, lightStrength);
}
#endif
