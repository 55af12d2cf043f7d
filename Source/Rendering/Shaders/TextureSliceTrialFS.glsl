// In place of the parts: rays through the volume that are the same whatever is seen of it, for finding
// out whether fragments or compute shaders are faster (vtkTextureSliceTrial).
#define TEXTURE_SLICE_LEAST_SLICES 0.0

uniform sampler3D volumeTexture;
uniform int samples;
// Texture coordinates for one pixel.
uniform float pixelToTexture;

vec3 trialOrigin = vec3(0.0);

bool StartRay(vec2 pixel, float leastSlices)
{
  trialOrigin = vec3(pixel * pixelToTexture, leastSlices);
  return true;
}

vec4 March()
{
  vec4 sum = vec4(0.0);
  vec3 trialStep = (vec3(0.5, 0.5, 1.0) - trialOrigin) / float(samples);
  for (int i = 0; i < samples; ++i)
  {
    vec4 scalars = textureLod(volumeTexture, trialOrigin + float(i) * trialStep, 0.0);
    sum += (1.0 - sum.a) * 0.01 * vec4(scalars.rgb, 1.0);
  }
  return sum;
}
