#ifdef TEXTURE_SLICE_SKIPPING
// Rays leap over empty bricks (vtkTextureSliceDistanceMap).
uniform sampler3D distanceMap;
// From texture coordinates to bricks.
uniform vec3 brickScale;
uniform vec3 brickBias;
uniform vec3 lastBrick;

// The ray in bricks, its slices for each brick, and whether it goes towards higher bricks.
vec3 brickOrigin = vec3(0.0);
vec3 brickStep = vec3(0.0);
vec3 perBrick = vec3(0.0);
vec3 forward = vec3(0.0);
// The first layer of the map of the ray's octant.
int octantLayer = 0;

// Slices; rounding would leave a ray on the face that it goes through.
const float intoNextBrick = 1e-3;

void StartSkipping()
{
  brickOrigin = rayOrigin * brickScale + brickBias;
  brickStep = rayStep * brickScale;
  perBrick = 1.0 / (brickStep + 1e-20);
  forward = step(0.0, perBrick);
  octantLayer = int(dot(1.0 - forward, vec3(1.0, 2.0, 4.0)) * (lastBrick.z + 1.0) + 0.5);
}

// How many slices on from a place the ray leaves its brick, or the empty bricks ahead of it.
float FindReach(float at, out bool empty)
{
  vec3 place = brickOrigin + at * brickStep;
  vec3 brick = clamp(floor(place), vec3(0.0), lastBrick);
  float distance =
    floor(texelFetch(distanceMap, ivec3(brick) + ivec3(0, 0, octantLayer), 0).r * 255.0 + 0.5);
  empty = distance > 0.0;
  vec3 further = (2.0 * forward - 1.0) * max(distance - 1.0, 0.0);
  vec3 reach = (brick + forward + further - place) * perBrick;
  return clamp(min(reach.x, min(reach.y, reach.z)), 0.0, 32768.0);
}
#endif

// Where a ray ends, because what is behind adds less than a quarter of one of 255.
const float opaque = 1023.0 / 1024.0;

// From front to back along a ray. Where there is something to skip, an inner loop leaps until all rays that a
// processor goes along together stand in visible bricks: software OpenGL has loops, but no branches.

#if TEXTURE_SLICE_BLEND == TEXTURE_SLICE_PLANE
// In texture coordinates; the plane that is shown is where it is 0.
uniform vec4 slicePlane;

vec4 March()
{
  float at = -dot(slicePlane, vec4(rayOrigin, 1.0)) / dot(slicePlane.xyz, rayStep);
  if (at >= raySpan.x && at <= raySpan.y)
  {
    GatherSample(at);
    EndTurn();
  }
  return FindPicture();
}
#elif TEXTURE_SLICE_BLEND == TEXTURE_SLICE_ISOSURFACE
// Surfaces between two planes, or a plane and an end of the ray. The inner loop goes on to the next surface.
vec4 March()
{
#ifdef TEXTURE_SLICE_SKIPPING
  StartSkipping();
  float known = raySpan.x; // up to there the ray is in bricks that were looked at
#endif
  GoOn(raySpan.x, true);
  while (picture.a <= opaque)
  {
    while (nearEnd.level == farEnd.level && farEnd.at < raySpan.y)
    {
      float next = floor(farEnd.at) + 1.0;
      bool empty = false;
#ifdef TEXTURE_SLICE_SKIPPING
      if (farEnd.at >= known)
      {
        known = farEnd.at + FindReach(farEnd.at, empty);
        known += empty ? intoNextBrick : 0.0;
        next = empty ? max(farEnd.at, floor(known)) : next;
      }
#endif
      GoOn(min(next, raySpan.y), empty);
    }
    if (nearEnd.level == farEnd.level)
    {
      break;
    }
    GatherSurface();
  }
  return FindPicture();
}
#elif defined TEXTURE_SLICE_SLABS
// What lies between two planes, or a plane and an end of the ray, is gathered together.
const float piece = float(TEXTURE_SLICE_SLABS);

vec4 March()
{
  float at = raySpan.x;
  SlabEnd frontEnd = FetchEnd(PlaceAt(at));
#ifdef TEXTURE_SLICE_SKIPPING
  StartSkipping();
  float known = at; // up to there the ray is in a brick that was looked at
#endif
  while (at < raySpan.y)
  {
#ifdef TEXTURE_SLICE_SKIPPING
    // A piece may be longer than a brick: it is left out where all bricks that it goes through are empty.
    float clear = at;
    bool empty = at >= known;
    while (empty && clear < raySpan.y)
    {
      float reach = FindReach(clear, empty);
      known = clear + reach;
      clear = empty ? known + intoNextBrick : clear;
    }
    if (clear >= raySpan.y)
    {
      break;
    }
    float start = max(at, floor(clear / piece) * piece);
    if (start > at)
    {
      at = start;
      frontEnd = FetchEnd(PlaceAt(at));
    }
#endif
    // The first piece is short: where it hides all that is behind it, its samples lie beside each other.
    float next = min(at == raySpan.x ? at + 0.5 : (floor(at / piece) + 1.0) * piece, raySpan.y);
    GatherPiece(at, next, frontEnd);
    if (picture.a > opaque)
    {
      break;
    }
    at = next;
  }
  return FindPicture();
}
#else
// Slices that the sample on a plane stands for: half of one on either side. The first and the last
// sample on a ray stand for all up to its end, so that each ray has its exact length.
float CountSlices(float at)
{
  vec2 ends = vec2(at - raySpan.x, raySpan.y - at);
  return (ends.x < 1.0 ? ends.x : 0.5) + (ends.y < 1.0 ? ends.y : 0.5);
}

// Several samples in one turn of the loop cost software OpenGL less than as many turns.
#if defined TEXTURE_SLICE_GRADIENT
const int samplesInTurn = 1; // it would take too long to compile
#elif TEXTURE_SLICE_BLEND == TEXTURE_SLICE_COMPOSITE || TEXTURE_SLICE_BLEND == TEXTURE_SLICE_AVERAGE
#ifdef TEXTURE_SLICE_LIT_TURNS
const int samplesInTurn = 3; // with one look-up of light
#else
const int samplesInTurn = 2;
#endif
#else
const int samplesInTurn = 4;
#endif

vec4 March()
{
  int i = int(ceil(raySpan.x));
  int last = int(floor(raySpan.y));
  int first = i;
  float unitsOfSlice = length(sampleStep);
#ifdef TEXTURE_SLICE_SKIPPING
  StartSkipping();
  int known = i; // before it the ray is in a brick that was looked at
#endif
  while (i <= last)
  {
#ifdef TEXTURE_SLICE_SKIPPING
    while (i >= known && i <= last)
    {
      bool empty;
      known = i + int(FindReach(float(i), empty)) + 1;
      i = empty ? known : i;
    }
    if (i > last)
    {
      break;
    }
#endif
    // Where the first sample hides all that is behind it, the others of its turn lie beside it.
    int end = min(i == first ? i + 1 : i + samplesInTurn, last + 1);
    for (int k = 0; k < samplesInTurn; ++k)
    {
      if (i + k < end)
      {
        float at = float(min(i + k, end - 1));
        sampleUnits = CountSlices(at) * unitsOfSlice;
        GatherSample(at);
      }
    }
    EndTurn();
    i = end;
#if TEXTURE_SLICE_BLEND == TEXTURE_SLICE_COMPOSITE
    if (picture.a > opaque)
    {
      break;
    }
#endif
  }
#if TEXTURE_SLICE_BLEND == TEXTURE_SLICE_ADDITIVE && defined TEXTURE_SLICE_SKIPPING
  // A sum of 0 is black wherever there are samples.
  for (i = first; i <= last && samples.x <= 0.0; ++i)
  {
    vec4 scalars;
    textureCoordinate = PlaceAt(float(i));
    samples.x = IsLeft(textureCoordinate) && FetchScalars(textureCoordinate, scalars) ? 1.0 : 0.0;
  }
#endif
  return FindPicture();
}
#endif
