#version 420
#extension GL_ARB_compute_shader : require
// SPDX-License-Identifier: BSD-3-Clause
// A pixel of the volume: its ray, from front to back, as a compute shader.
layout(local_size_x = 64) in;

layout(rgba16) writeonly uniform image2D pictureImage;
// The rectangle of pixels to be drawn: the lower left one, and where it ends.
uniform ivec2 firstPixel;
uniform ivec2 endOfPixels;

//VTK::TextureSlice::Parts

void main()
{
  // Four columns and two rows at a time, one block of rows after the other: such rays meet the same voxels.
  int i = int(gl_LocalInvocationIndex);
  ivec2 pixel = firstPixel + 8 * ivec2(gl_WorkGroupID.yx) +
                ivec2((i & 3) | (i >> 1 & 4), (i >> 2 & 1) | (i >> 3 & 6));
  if (all(lessThan(pixel, endOfPixels)) && StartRay(vec2(pixel) + 0.5))
  {
    imageStore(pictureImage, pixel, March());
  }
}
