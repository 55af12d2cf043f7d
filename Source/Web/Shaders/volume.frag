// SPDX-License-Identifier: BSD-3-Clause
// The colours of the volume along the ray of a pixel, from front to back. Positions are in texture coordinates of the volume
// or of its detail (0 to 1 between its outer faces), lengths along the ray in km of the stretched scene.
//
// Defined before this text: BLENDED (two times are blended), MASKED (voxels without a value have none, rather than the
// value of byte 0), SURFACES (how many surfaces are drawn in place of the volume; 0 for none), DETAIL (a finer volume is
// drawn in place of a part of the other one; then nothing is blended), ENTRIES (of the integrals), BRICK (its voxels).
precision highp float;
precision highp int;
precision highp sampler3D;
precision highp usampler3D;

in vec2 place;
out vec4 colour;

uniform sampler3D volume; // red: byte / 255 (times green, where MASKED); green: 1 where there is a value
uniform sampler3D nextVolume;
uniform float blend; // 0: the volume, 1: the next one
uniform usampler3D distances; // of each brick to the nearest visible one; 0 within it
uniform usampler3D nextDistances;
uniform sampler2D integrals; // Formulas L1
uniform sampler2D colours; // of the values, for surfaces

uniform vec3 voxels; // along x, y and z
uniform vec3 boxSize; // km
uniform vec3 rayOrigin, rayOriginX, rayOriginY; // texture coordinates
uniform vec3 rayDirection, rayDirectionX, rayDirectionY; // likewise
uniform vec4 cut; // what has dot(cut, vec4(position, 1)) below 0 is not drawn
uniform float stepVoxels; // length of a step, in voxels of the axis along which the ray advances most
uniform float depthPerKilometre; // 1 over the unit distance of opacities, times the strength that the user chose

#if SURFACES > 0
uniform vec2 surfaces[SURFACES]; // byte / 255, and opacity
#endif

#if DETAIL
uniform sampler3D detailVolume;
uniform usampler3D detailDistances;
uniform vec3 detailVoxels;
uniform vec3 detailLower, detailUpper; // its outer faces, in texture coordinates of the whole volume
#endif

const float lastEntry = float(ENTRIES - 1);
const int mostSteps = 4096;

// The volume in whose texture coordinates positions are.
struct Grid {
  vec3 voxels; // along x, y and z
  vec3 size; // km
  bool fine; // whether it is the detail
};
Grid grid;

vec4 fetchVoxels(vec3 position) {
#if DETAIL
  if (grid.fine) {
    return texture(detailVolume, position);
  }
#endif
  vec4 found = texture(volume, position);
#if BLENDED
  found = mix(found, texture(nextVolume, position), blend);
#endif
  return found;
}

// The value at a place as byte / 255, and how much of a value there is.
vec2 sampleVolume(vec3 position) {
  vec2 found = fetchVoxels(position).rg;
#if MASKED
  return vec2(found.r / max(found.g, 1e-3), found.g);
#else
  return vec2(found.r, 1.0);
#endif
}

// Where the ray enters and leaves the volume.
vec2 findRange(vec3 origin, vec3 direction) {
  vec3 first = 0.5 / grid.voxels; // the centres of the outer voxels are the ends of the volume
  vec3 one = (first - origin) / direction;
  vec3 two = (1.0 - first - origin) / direction;
  vec3 enter = min(one, two);
  vec3 leave = max(one, two);
  return vec2(max(max(enter.x, enter.y), enter.z), min(min(leave.x, leave.y), leave.z));
}

// What the camera and the cut leave of a range along the ray, whose origin and direction are those in the whole volume.
vec2 limitRange(vec2 range, vec3 origin, vec3 direction) {
  float approach = dot(cut.xyz, direction);
  float crossing = -dot(cut, vec4(origin, 1.0)) / approach;
  if (approach > 0.0) {
    range.x = max(range.x, crossing);
  } else if (approach < 0.0) {
    range.y = min(range.y, crossing);
  } else if (dot(cut, vec4(origin, 1.0)) < 0.0) {
    range.y = range.x;
  }
  return vec2(max(range.x, 0.0), range.y);
}

uint fetchDistance(ivec3 brick) {
#if DETAIL
  if (grid.fine) {
    return texelFetch(detailDistances, brick, 0).r;
  }
#endif
  uint distance = texelFetch(distances, brick, 0).r;
#if BLENDED
  distance = min(distance, texelFetch(nextDistances, brick, 0).r);
#endif
  return distance;
}

// How far along the ray the bricks about a position have nothing to see; 0 in a visible brick.
float findEmptyWay(vec3 position, vec3 direction) {
  vec3 bricks = grid.voxels / float(BRICK);
  vec3 inBricks = clamp(position * bricks, vec3(0.0), ceil(bricks) - 1.0);
  vec3 brick = floor(inBricks);
  float reach = float(fetchDistance(ivec3(brick)));
  if (reach == 0.0) {
    return 0.0;
  }
  vec3 sign = step(vec3(0.0), direction);
  vec3 edge = brick + mix(vec3(1.0 - reach), vec3(reach), sign);
  vec3 ways = (edge / bricks - position) / direction;
  return max(min(min(ways.x, ways.y), ways.z), 0.0);
}

vec4 fetchIntegral(float entry) {
  return texelFetch(integrals, ivec2(int(entry), 0), 0);
}

#if SURFACES > 0

// The gradient of the values, over two voxels on either side because the echo of a gate is noisy. km.
vec3 findGradient(vec3 position) {
  vec3 gradient;
  for (int axis = 0; axis < 3; ++axis) {
    vec3 aside = vec3(0.0);
    aside[axis] = 1.5 / grid.voxels[axis];
    gradient[axis] = (sampleVolume(position + aside).x - sampleVolume(position - aside).x) /
      (2.0 * aside[axis] * grid.size[axis]);
  }
  return gradient;
}

// A surface as a headlight shows it, with the material that the program gives surfaces
// (Source/Scene/VolumeAppearance.cxx). Premultiplied by its opacity.
vec4 shadeSurface(vec3 position, vec3 toEye, vec2 surface) {
  vec3 own = texelFetch(colours, ivec2(int(surface.x * 510.0 + 0.5), 0), 0).rgb;
  vec3 gradient = findGradient(position);
  float facing = abs(dot(gradient, toEye)) / max(length(gradient), 1e-9);
  float shine = 0.2 * pow(facing, 10.0);
  vec3 lit = min((0.1 + 0.7 * facing) * own + shine, vec3(1.0));
  return vec4(lit, 1.0) * surface.y;
}

// Adds the surfaces that lie between two values, the nearest first.
void addSegment(inout vec4 sum, float front, float back, vec3 from, vec3 to, float way) {
  for (int i = 0; i < SURFACES; ++i) {
    int number = back > front ? i : SURFACES - 1 - i; // ascending where the values ascend
    vec2 surface = surfaces[number];
    if ((front < surface.x) != (back < surface.x)) {
      vec3 place = mix(from, to, (surface.x - front) / (back - front));
      sum += (1.0 - sum.a) * shadeSurface(place, normalize((from - to) * grid.size), surface);
    }
  }
}

#else

// Adds what lies between two values that are `way` km apart (Formulas L1).
void addSegment(inout vec4 sum, float front, float back, vec3 from, vec3 to, float way) {
  float first = floor(front * lastEntry + 0.5);
  float last = floor(back * lastEntry + 0.5);
  if (first == last) {
    last = first < lastEntry ? first + 1.0 : first - 1.0;
  }
  vec4 difference = abs(fetchIntegral(last) - fetchIntegral(first));
  if (difference.a <= 0.0) {
    return;
  }
  float depth = difference.a / abs(last - first) * way * depthPerKilometre;
  vec3 own = min(difference.rgb / difference.a, vec3(1.0));
  sum += (1.0 - sum.a) * (1.0 - exp2(-depth)) * vec4(own, 1.0);
}

#endif

// Adds what lies in a range along the ray.
void march(inout vec4 sum, vec3 origin, vec3 direction, vec2 range) {
  float kilometres = length(direction * grid.size);
  vec3 voxelsPerWay = abs(direction) * grid.voxels;
  float stride = stepVoxels / max(max(voxelsPerWay.x, voxelsPerWay.y), voxelsPerWay.z);
  float at = range.x;
  bool known = false; // whether `front` is the value at `at`
  vec2 front = vec2(0.0);
  for (int i = 0; i < mostSteps && at < range.y && sum.a < 0.995; ++i) {
    vec3 from = origin + at * direction;
    // Steps stay where they would be without empty space. The one in which it ends is taken as any other.
    float empty = floor(findEmptyWay(from, direction) / stride);
    if (empty > 0.0) {
      at += empty * stride;
      from = origin + at * direction;
      known = false;
      if (at >= range.y) {
        break;
      }
    }
    float end = min(at + stride, range.y);
    vec3 to = origin + end * direction;
    if (!known) {
      front = sampleVolume(from);
    }
    vec2 back = sampleVolume(to);
#if MASKED
    if (max(front.y, back.y) >= 0.5) {
      // A hidden end has the value of the other one; half of the way counts.
      float left = front.y < 0.5 ? back.x : front.x;
      float right = back.y < 0.5 ? front.x : back.x;
      float share = min(front.y, back.y) >= 0.5 ? 1.0 : 0.5;
      addSegment(sum, left, right, from, to, share * (end - at) * kilometres);
    }
#else
    addSegment(sum, front.x, back.x, from, to, (end - at) * kilometres);
#endif
    front = back;
    known = true;
    at = end;
  }
}

#if DETAIL

// At a face of the detail the value jumps. Surfaces of values between both ends are closed there.
void addFace(inout vec4 sum, vec2 front, vec2 back, vec3 position, vec3 direction) {
#if SURFACES > 0
  if (min(front.y, back.y) >= 0.5) {
    addSegment(sum, front.x, back.x, position - 1e-4 * direction, position, 0.0);
  }
#endif
}

// Before, within and behind the detail.
void marchParts(inout vec4 sum, vec3 origin, vec3 direction) {
  Grid whole = grid;
  vec3 extent = detailUpper - detailLower;
  Grid detail = Grid(detailVoxels, boxSize * extent, true);
  vec3 detailOrigin = (origin - detailLower) / extent;
  vec3 detailDirection = direction / extent;
  vec2 outer = limitRange(findRange(origin, direction), origin, direction);
  grid = detail;
  vec2 inner = limitRange(findRange(detailOrigin, detailDirection), origin, direction);
  inner = inner.x < inner.y ? inner : vec2(outer.y);
  vec2 last = vec2(0.0); // the value where the part before ends
  for (int part = 0; part < 3; ++part) {
    grid = whole;
    vec3 from = origin;
    vec3 way = direction;
    vec2 range = part == 0 ? vec2(outer.x, min(outer.y, inner.x)) : vec2(max(outer.x, inner.y), outer.y);
    if (part == 1) {
      grid = detail;
      from = detailOrigin;
      way = detailDirection;
      range = inner;
    }
    if (range.x < range.y) {
      addFace(sum, last, sampleVolume(from + range.x * way), from + range.x * way, way);
      march(sum, from, way, range);
      last = sampleVolume(from + range.y * way);
    }
  }
}

#endif

void main() {
  vec3 origin = rayOrigin + place.x * rayOriginX + place.y * rayOriginY;
  vec3 direction = rayDirection + place.x * rayDirectionX + place.y * rayDirectionY;
  direction = mix(direction, vec3(1e-9), lessThan(abs(direction), vec3(1e-9)));
  grid = Grid(voxels, boxSize, false);
  vec4 sum = vec4(0.0);
#if DETAIL
  marchParts(sum, origin, direction);
#else
  march(sum, origin, direction, limitRange(findRange(origin, direction), origin, direction));
#endif
  colour = sum;
}
