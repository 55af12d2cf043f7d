// What of the light arrives at a sample.
#ifdef TEXTURE_SLICE_SHADOWS

// Red: the transmittance to the light. Green: its mean over the sky (Formulas L2).
uniform sampler3D lightTexture;
// From the volume's texture coordinates to those of the light.
uniform vec3 lightTextureScale;
// How strong shadow and occlusion are, 0 to 1.
uniform vec2 lightStrength;

#ifdef TEXTURE_SLICE_SCATTERING
// Half of VolumetricScatteringBlending.
uniform float scattering;
#endif

// Of the light, and of the sky's, with shadow and occlusion at full strength.
vec2 FetchTransmittance()
{
  return texture(lightTexture, textureCoordinate * lightTextureScale).rg;
}

vec2 Weaken(vec2 transmittance)
{
  return mix(vec2(1.0), transmittance, lightStrength);
}
#endif
