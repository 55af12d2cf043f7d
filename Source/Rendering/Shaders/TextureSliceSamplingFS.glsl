// The scalars and their gradient, and the mask.

uniform sampler3D volumeTexture;

// From a texel to 0 to 1 over the range of each component.
uniform vec4 scalarScale;
uniform vec4 scalarBias;

#ifdef TEXTURE_SLICE_RECTILINEAR
// For each axis, from the place in the box to the part of the points' intervals before it.
uniform sampler1D coordinateTable;

// Texture coordinates where the points are of equal distances to those of the texture.
vec3 Place(vec3 at)
{
  // The centres of the first and the last entry are the faces of the box.
  float entries = float(textureSize(coordinateTable, 0));
  vec3 entry = ((at - textureBias) / textureScale * (entries - 1.0) + 0.5) / entries;
  vec3 part = vec3(textureLod(coordinateTable, entry.x, 0.0).x, textureLod(coordinateTable, entry.y, 0.0).y,
    textureLod(coordinateTable, entry.z, 0.0).z);
  return part * textureScale + textureBias;
}
#else
vec3 Place(vec3 at)
{
  return at;
}
#endif

#ifdef TEXTURE_SLICE_PAGED
// The volume's texture is an atlas of pages (vtkTextureSlicePages): for each page of the volume its place there,
// counted in pages.
uniform sampler3D pageTable;
uniform vec3 volumeTexels;
uniform vec3 pageIntervals;
uniform vec3 pageTexels;
uniform vec3 lastPage;
uniform vec3 atlasTexels;

vec3 CountTexels()
{
  return volumeTexels;
}

vec4 FetchTexel(vec3 at)
{
  vec3 texel = clamp(Place(at) * volumeTexels - 0.5, vec3(0.0), volumeTexels - 1.0);
  vec3 page = min(floor(texel / pageIntervals), lastPage);
  vec3 slot = floor(texelFetch(pageTable, ivec3(page), 0).xyz * 255.0 + 0.5);
  vec3 within = texel - min(page * pageIntervals, volumeTexels - pageTexels);
  return textureLod(volumeTexture, (slot * pageTexels + within + 0.5) / atlasTexels, 0.0);
}
#else
vec3 CountTexels()
{
  return vec3(textureSize(volumeTexture, 0));
}

vec4 FetchTexel(vec3 at)
{
  return textureLod(volumeTexture, Place(at), 0.0);
}
#endif

#ifdef TEXTURE_SLICE_BLANKED
// Above 0 where the ghost flags of cells (or of points, for scalars of cells) hide what is there.
uniform sampler3D blankTexture;

bool IsBlanked(vec3 at)
{
  // The first cell lies between two points, the first point at the corner of a cell.
  vec3 flags = vec3(textureSize(blankTexture, 0));
  vec3 texels = CountTexels();
  vec3 place = (Place(at) * texels + 0.5 * (flags - texels)) / flags;
  return textureLod(blankTexture, place, 0.0).r > 0.0;
}
#endif

#if defined TEXTURE_SLICE_MASKED && TEXTURE_SLICE_BLEND == TEXTURE_SLICE_ISOSURFACE
#define TEXTURE_SLICE_STAIR 1
// One voxel along its shortest edge, as texture coordinates, and how many of them make half of its
// longest one.
uniform vec4 stair;

// The visible part of the points about a place between visible and hidden ones. A slanted edge of what
// is visible is a stair of voxels, whose steps are many voxels high where voxels are flat: the mean over
// about the height of a step makes a slope of it.
float FindVisiblePart(vec3 at, float here)
{
  float sum = here;
  for (float i = 1.0; i <= stair.w; ++i)
  {
    sum += FetchTexel(at - i * stair.xyz)[TEXTURE_SLICE_COMPONENTS];
    sum += FetchTexel(at + i * stair.xyz)[TEXTURE_SLICE_COMPONENTS];
  }
  return sum / (1.0 + 2.0 * stair.w);
}
#endif

// Below 0 where there is nothing to see. The last component of masked texels is 1 at visible points and 0 at
// hidden ones, where the others are 0 too: their quotient is the mean of the visible points alone.
float FetchVisibility(vec3 at, out vec4 scalars)
{
  scalars = FetchTexel(at);
  float visible = 1.0;
#ifdef TEXTURE_SLICE_MASKED
  visible = scalars[TEXTURE_SLICE_COMPONENTS];
#ifdef TEXTURE_SLICE_STAIR
  const float least = 0.0625; // of visible points
#else
  const float least = 0.5;
#endif
  scalars /= max(visible, least);
#endif
  scalars = scalars * scalarScale + scalarBias;
#ifdef TEXTURE_SLICE_STAIR
  if (abs(visible - 0.5) < 0.5 - least)
  {
    visible = FindVisiblePart(at, visible);
  }
#endif
#ifdef TEXTURE_SLICE_BLANKED
  visible = IsBlanked(at) ? 0.0 : visible;
#endif
  return visible - 0.5;
}

// False where there is nothing to see.
bool FetchScalars(vec3 at, out vec4 scalars)
{
  return FetchVisibility(at, scalars) >= 0.0;
}

#ifdef TEXTURE_SLICE_SECOND_ARRAY
// The array that two-dimensional functions have in place of the gradient magnitude.
uniform sampler3D secondTexture;
uniform vec4 secondScale;
uniform vec4 secondBias;

// 0 to 1 over the component's range; of masked texels, the mean of the visible points.
float FetchSecond(vec3 at, int component)
{
  vec4 texel = textureLod(secondTexture, Place(at), 0.0);
#ifdef TEXTURE_SLICE_SECOND_MASKED
  texel /= max(texel[TEXTURE_SLICE_SECOND_ARRAY], 0.5);
#endif
  return texel[component] * secondScale[component] + secondBias[component];
}
#endif

#if defined TEXTURE_SLICE_BINARY_MASK || defined TEXTURE_SLICE_LABELS
// 0 to 255 as 0 to 1.
uniform sampler3D maskTexture;

// 0: no label, or one beyond the last that has functions of its own.
int FetchLabel(vec3 at)
{
  int label = int(textureLod(maskTexture, Place(at), 0.0).r * 255.0 + 0.5);
#ifdef TEXTURE_SLICE_LABELS
  label = label > TEXTURE_SLICE_LABELS ? 0 : label;
#endif
  return label;
}
#endif

#ifdef TEXTURE_SLICE_GRADIENT
// One voxel along each axis, as texture coordinates.
uniform vec3 voxelStep;
// The mean spacing over twice the spacing along each axis.
uniform vec3 inverseAspect;

#ifdef TEXTURE_SLICE_CLIPPED_SCALARS
// What is clipped away has this scalar, 0 to 1 over the range of each component.
uniform vec4 clippedScalars;
#endif

// A hidden neighbour counts as the sample itself: the edge of what is visible is not a slope.
float FetchNeighbour(vec3 at, int component, float here)
{
#ifdef TEXTURE_SLICE_CLIPPED_SCALARS
  for (int i = 0; i < TEXTURE_SLICE_CLIPPING_PLANES; ++i)
  {
    if (dot(clippingPlanes[i], vec4(at, 1.0)) < 0.0)
    {
      return clippedScalars[component];
    }
  }
#endif
  vec4 scalars;
  return FetchScalars(at, scalars) ? scalars[component] : here;
}

#ifdef TEXTURE_SLICE_SMOOTH_GRADIENT
// Differences between the corners of a cube that is three voxels wide, each a mean of eight voxels.
vec3 Differences(float here, int component)
{
  const float reach = 1.5;
  vec3 differences = vec3(0.0);
  for (int corner = 0; corner < 8; ++corner)
  {
    vec3 side = vec3(ivec3(corner, corner >> 1, corner >> 2) & 1) * 2.0 - 1.0;
    differences +=
      side * FetchNeighbour(textureCoordinate + reach * side * voxelStep, component, here);
  }
  return differences / (4.0 * reach);
}
#else
// Central differences: the change of the scalar over two voxels along each axis.
vec3 Differences(float here, int component)
{
  vec3 differences;
  for (int axis = 0; axis < 3; ++axis)
  {
    vec3 offset = vec3(0.0);
    offset[axis] = voxelStep[axis];
    differences[axis] = FetchNeighbour(textureCoordinate + offset, component, here) -
      FetchNeighbour(textureCoordinate - offset, component, here);
  }
  return differences;
}
#endif

// xyz: the gradient in data coordinates; w: 0 to 1 for a quarter of the scalars' range over the mean spacing.
vec4 Gradient(vec4 scalars, int component)
{
  vec3 gradient = Differences(scalars[component], component) * inverseAspect;
  return vec4(gradient, clamp(4.0 * length(gradient), 0.0, 1.0));
}
#endif

#ifdef TEXTURE_SLICE_CROPPED
// The six cropping planes as texture coordinates, and one bit for each of the 27 regions between them.
uniform vec3 cropLow;
uniform vec3 cropHigh;
uniform int cropFlags;
#endif

// Whether cropping and mask leave what is there.
bool IsLeft(vec3 at)
{
#ifdef TEXTURE_SLICE_CROPPED
  ivec3 region = ivec3(greaterThanEqual(at, cropLow)) + ivec3(greaterThan(at, cropHigh));
  if (((cropFlags >> (region.x + 3 * region.y + 9 * region.z)) & 1) == 0)
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
