// The ray of a pixel. Places on it are counted in slices: 0 is the nearest plane, 1 the next one.

// From a pixel to its place on the nearest plane, and its way to the next one, as texture coordinates.
uniform mat3 placeOfPixel;
uniform mat3 stepOfPixel;
// From the box (0 to 1 along each axis) to texture coordinates.
uniform vec3 textureScale;
uniform vec3 textureBias;
// From texture coordinates to data lengths along the axes, in the first component's unit distances.
uniform vec3 stepToUnits;
uniform vec3 partLow;
uniform vec3 partHigh;
#if TEXTURE_SLICE_CLIPPING_PLANES > 0
// In texture coordinates; what is below 0 is cut away.
uniform vec4 clippingPlanes[TEXTURE_SLICE_CLIPPING_PLANES];
#endif
// See vtkTextureSlicePlanes::DepthToSlice.
uniform vec4 depthToSlice;
// Pixels of the window for one pixel of the picture.
uniform float pixelSize;
#ifndef TEXTURE_SLICE_PEEL
// Depth of the opaque geometry, 0 to 1.
uniform sampler2D geometryDepth;
#endif

vec3 rayOrigin = vec3(0.0);
vec3 rayStep = vec3(0.0);
// To the next slice along the ray, in the first component's unit distances.
vec3 sampleStep = vec3(0.0);
// Where the ray enters and leaves what is drawn.
vec2 raySpan = vec2(0.0);
ivec2 windowPixel = ivec2(0);

// Where the volume is sampled, and how many unit distances the sample stands for.
float sampleAt = 0.0;
vec3 textureCoordinate = vec3(0.0);
float sampleUnits = 0.0;

#ifdef TEXTURE_SLICE_PEEL
// Depth peeling: between which depths of the window a pixel's part of the volume lies. The textures of
// VTK's pass have a negative nearest depth and a farthest depth; -1 stands for none.

// Whether the picture is that of what lies in front of the geometry that is left.
uniform int peelInFront;

const vec2 nothing = vec2(3.0, -3.0);

#if TEXTURE_SLICE_PEEL == TEXTURE_SLICE_PEEL_REST
uniform sampler2D depthRangeTex;

vec2 PeelRange()
{
  vec2 left = texelFetch(depthRangeTex, windowPixel, 0).xy;
  return left.x == -1.0 ? nothing : vec2(-left.x, left.y);
}
#else
// The last geometry that was peeled; at first, the opaque geometry.
uniform sampler2D outerDepthTex;
// The geometry to be peeled next.
uniform sampler2D innerDepthTex;

vec2 PeelRange()
{
  vec2 outer = texelFetch(outerDepthTex, windowPixel, 0).xy;
  vec2 inner = texelFetch(innerDepthTex, windowPixel, 0).xy;
#if TEXTURE_SLICE_PEEL == TEXTURE_SLICE_PEEL_OUTSIDE
  outer = vec2(2.0, outer.y < 0.0 ? 2.0 : outer.y); // nothing was peeled: from the eye on
  bool wholeInFront = false;
#else
  bool wholeInFront = true;
  if (outer.x == -1.0)
  {
    return nothing;
  }
#endif
  if (inner.x == -1.0) // nothing is left to be peeled
  {
    return (peelInFront != 0) == wholeInFront ? vec2(-outer.x, outer.y) : nothing;
  }
  return peelInFront != 0 ? vec2(-outer.x, -inner.x) : vec2(inner.y, outer.y);
}
#endif
#endif

vec3 PlaceAt(float at)
{
  return rayOrigin + at * rayStep;
}

// The place on the ray at a depth of the window.
float SliceAtDepth(float depth)
{
  float lack = 2.0 * (1.0 - depth);
  return (depthToSlice.x - lack * depthToSlice.y) / (depthToSlice.z + lack * depthToSlice.w);
}

// Between the faces of the part, the near plane, the clipping planes and the opaque geometry.
vec2 FindSpan()
{
  vec3 perStep = 1.0 / (rayStep + 1e-20); // not 0 along a face
  vec3 low = (partLow - rayOrigin) * perStep;
  vec3 high = (partHigh - rayOrigin) * perStep;
  vec3 entry = min(low, high);
  vec3 exit = max(low, high);
  vec2 span = vec2(max(max(entry.x, entry.y), max(entry.z, -0.5)), min(min(exit.x, exit.y), exit.z));
#if TEXTURE_SLICE_CLIPPING_PLANES > 0
  for (int i = 0; i < TEXTURE_SLICE_CLIPPING_PLANES; ++i)
  {
    float distance = dot(clippingPlanes[i], vec4(rayOrigin, 1.0));
    float approach = dot(clippingPlanes[i].xyz, rayStep);
    approach = approach == 0.0 ? 1e-20 : approach;
    float crossing = -distance / approach;
    span = approach > 0.0 ? vec2(max(span.x, crossing), span.y) : vec2(span.x, min(span.y, crossing));
  }
#endif
#ifdef TEXTURE_SLICE_PEEL
  vec2 range = PeelRange();
  if (range.x >= range.y)
  {
    return vec2(0.0);
  }
  span.x = range.x > 0.0 ? max(span.x, SliceAtDepth(range.x)) : span.x;
  span.y = min(span.y, SliceAtDepth(min(range.y, 1.0)));
#else
  span.y = min(span.y, SliceAtDepth(texelFetch(geometryDepth, windowPixel, 0).r));
#endif
  return span;
}

// What each ray has, however short its way.
#ifdef TEXTURE_SLICE_SLABS
const float leastSlices = 4.0;
#else
const float leastSlices = 2.0;
#endif

// Of a ray with slices of its own, the plane that is nearest to their middle; else below 0.
float ownPlane = -1.0;

// False where the ray meets nothing that is drawn. A ray with a short way has slices of its own.
bool StartRay(vec2 pixel)
{
  windowPixel = ivec2(pixel * pixelSize);
  rayOrigin = placeOfPixel * vec3(pixel, 1.0);
  rayStep = stepOfPixel * vec3(pixel, 1.0);
  raySpan = FindSpan();
  float way = raySpan.y - raySpan.x;
  if (!(way > 0.0))
  {
    return false;
  }
  if (way < leastSlices)
  {
    float own = way / leastSlices;
    ownPlane = floor(0.5 * (raySpan.x + raySpan.y) + 0.5);
    rayOrigin = PlaceAt(raySpan.x + 0.5 * own);
    rayStep *= own;
    raySpan = vec2(-0.5, leastSlices - 0.5);
  }
  sampleStep = rayStep * stepToUnits;
  return true;
}
