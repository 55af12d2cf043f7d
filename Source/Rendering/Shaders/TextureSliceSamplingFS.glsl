// The scalars and their gradient, and the mask.

uniform sampler3D volumeTexture;

// From a texel to 0 to 1 over the range of each component.
uniform vec4 scalarScale;
uniform vec4 scalarBias;

#ifdef TEXTURE_SLICE_MASKED
// Below 0 where there is nothing to see. The last component is 1 at visible points and 0 at hidden
// ones, where the others are 0 too. Their quotient is the mean of the visible points alone; where
// the hidden ones weigh more, there is nothing to see.
float FetchVisibility(vec3 at, out vec4 scalars)
{
  vec4 texel = texture(volumeTexture, at);
  float visible = texel[TEXTURE_SLICE_COMPONENTS];
  scalars = texel / max(visible, 0.5) * scalarScale + scalarBias;
  return visible - 0.5;
}

// False where there is nothing to see.
bool FetchScalars(vec3 at, out vec4 scalars)
{
  return FetchVisibility(at, scalars) >= 0.0;
}
#else
// False where there is nothing to see.
bool FetchScalars(vec3 at, out vec4 scalars)
{
  scalars = texture(volumeTexture, at) * scalarScale + scalarBias;
  return true;
}
#endif

#if defined TEXTURE_SLICE_BINARY_MASK || defined TEXTURE_SLICE_LABELS
// 0 to 255 as 0 to 1.
uniform sampler3D maskTexture;

// 0: no label. Labels without functions beyond the last one are drawn like it.
int FetchLabel(vec3 at)
{
  int label = int(texture(maskTexture, at).r * 255.0 + 0.5);
#ifdef TEXTURE_SLICE_LABELS
  label = min(label, TEXTURE_SLICE_LABELS);
#endif
  return label;
}
#endif

#ifdef TEXTURE_SLICE_GRADIENT
// One voxel along each axis, as texture coordinates.
uniform vec3 voxelStep;
// The mean spacing over twice the spacing along each axis.
uniform vec3 inverseAspect;

// A hidden neighbour counts as the sample itself: the edge of what is visible is not a slope.
float FetchNeighbour(vec3 at, int component, float here)
{
  vec4 scalars;
  return FetchScalars(at, scalars) ? scalars[component] : here;
}

// Central differences. xyz: the gradient in data coordinates, of any length; w: its magnitude, 0 to 1
// for a quarter of the scalars' range over the mean spacing.
vec4 Gradient(vec4 scalars, int component)
{
  vec3 gradient;
  for (int axis = 0; axis < 3; ++axis)
  {
    vec3 offset = vec3(0.0);
    offset[axis] = voxelStep[axis];
    gradient[axis] = FetchNeighbour(textureCoordinate + offset, component, scalars[component]) -
      FetchNeighbour(textureCoordinate - offset, component, scalars[component]);
  }
  gradient *= inverseAspect;
  return vec4(gradient, clamp(4.0 * length(gradient), 0.0, 1.0));
}
#endif
