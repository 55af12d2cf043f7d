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
