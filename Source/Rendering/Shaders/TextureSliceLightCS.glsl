#version 420
#extension GL_ARB_compute_shader : require
#extension GL_ARB_shader_storage_buffer_object : require
// SPDX-License-Identifier: BSD-3-Clause
// The light that arrives in cells from one direction (Formulas L2), as vtkTextureSliceLightVolume.cxx finds it: each
// ray goes from plane to plane; then each cell takes what arrives by the four rays about its centre.
layout(local_size_x = 8, local_size_y = 8) in;

// See vtkTextureSliceLightCourse.
struct Course
{
  ivec2 cells;
  ivec2 stride;
  ivec2 rays;
  vec2 slope;
  vec2 offset;
  vec2 lowMargin;
  vec2 highMargin;
  int planes;
  int first;
  int planeStride;
  float step;
  float margin;
  float weight;
};

layout(std430, binding = 0) readonly buffer Cells
{
  float cells[]; // extinctions, or with isosurfaces scalars
};
layout(std430, binding = 1) buffer Rays
{
  float transmittances[]; // at each plane, of the rays about its cells
};
layout(std430, binding = 2) buffer Sums
{
  float sums[];
};
layout(std430, binding = 3) readonly buffer Courses
{
  Course courses[];
};
layout(std430, binding = 4) readonly buffer Surfaces
{
  vec2 surfaces[]; // value and optical depth
};
uniform int countOfSurfaces;
// Of the course, and whether cells take what arrives.
uniform int number;
uniform bool gathering;
Course course = courses[number];

vec2 FindPlace(int plane)
{
  return max(course.slope * float(plane) + course.offset, vec2(0.0));
}

int RayAt(ivec2 cell, int plane)
{
  return (plane * (course.cells.y + 1) + cell.y) * (course.cells.x + 1) + cell.x;
}

int CellAt(ivec2 cell, int plane)
{
  ivec2 at = clamp(cell, ivec2(0), course.cells - 1) * course.stride;
  return course.first + plane * course.planeStride + at.x + at.y;
}

// The cells about a ray, which lies by a part of a cell before one of them.
float Interpolate(ivec2 cell, vec2 part, int plane)
{
  return mix(
    mix(cells[CellAt(cell, plane)], cells[CellAt(cell - ivec2(1, 0), plane)], part.x),
    mix(cells[CellAt(cell - ivec2(0, 1), plane)], cells[CellAt(cell - 1, plane)], part.x), part.y);
}

// Steps that the ray of a place among the cells has been inside of the sides of the volume.
float FindSteps(vec2 at)
{
  vec2 way = mix(course.highMargin + vec2(course.cells - 1) - at, course.lowMargin + at,
    lessThan(course.slope, vec2(0.0)));
  bvec2 still = equal(course.slope, vec2(0.0));
  vec2 steps = mix(way / (abs(course.slope) + vec2(still)), vec2(1.0), still);
  return min(steps.x, steps.y);
}

// The optical depth of a step, of which a part is inside of the volume.
float FindDepth(float before, float here, float steps)
{
  float depth = course.step * (steps < 1.0 ? steps * here : 0.5 * (before + here));
  // Not from outside of the volume, and not to or from what is hidden, which is not a number.
  bool crosses = steps >= 1.0 && abs(here - before) <= 3.4e38;
  depth = countOfSurfaces > 0 ? 0.0 : depth;
  for (int i = 0; i < countOfSurfaces; ++i)
  {
    depth += crosses && (before > surfaces[i].x) != (here > surfaces[i].x) ? surfaces[i].y : 0.0;
  }
  return depth;
}

void FollowRay(ivec2 ray)
{
  float depth = 0.0;
  float before = 0.0;
  for (int plane = 0; plane < course.planes; ++plane)
  {
    vec2 place = FindPlace(plane);
    ivec2 cell = ray - ivec2(place);
    if (all(greaterThanEqual(cell, ivec2(0))) && all(lessThanEqual(cell, course.cells)))
    {
      vec2 part = fract(place);
      float here = Interpolate(cell, part, plane);
      // The centre of an incomplete cell may be outside, before the face.
      vec2 range = plane == 0 ? vec2(min(0.0, course.margin), course.margin) : vec2(0.0, 1.0);
      depth += FindDepth(before, here, max(min(FindSteps(vec2(cell) - part), range.y), range.x));
      before = here;
      transmittances[RayAt(cell, plane)] = exp(-depth);
    }
  }
}

void AddToCell(ivec2 cell, int plane)
{
  vec2 part = fract(FindPlace(plane));
  int lower = RayAt(cell, plane);
  int upper = RayAt(cell + ivec2(0, 1), plane);
  sums[CellAt(cell, plane)] += course.weight *
    mix(mix(transmittances[lower], transmittances[lower + 1], part.x),
      mix(transmittances[upper], transmittances[upper + 1], part.x), part.y);
}

void main()
{
  ivec2 at = ivec2(gl_GlobalInvocationID.xy);
  if (!gathering)
  {
    FollowRay(at);
  }
  for (int plane = 0; gathering && all(lessThan(at, course.cells)) && plane < course.planes; ++plane)
  {
    AddToCell(at, plane);
  }
}
