#version 420
#extension GL_ARB_compute_shader : require
// SPDX-License-Identifier: BSD-3-Clause
// A pixel of the volume: its ray, from front to back, as a compute shader.
layout(local_size_x = 8, local_size_y = 8) in;

layout(rgba16) writeonly uniform image2D pictureImage;
// The rectangle of pixels to be drawn: the lower left one, and where it ends.
uniform ivec2 firstPixel;
uniform ivec2 endOfPixels;

//VTK::TextureSlice::Parts

void main()
{
  ivec2 pixel = firstPixel + ivec2(gl_GlobalInvocationID.xy);
  if (all(lessThan(pixel, endOfPixels)) && StartRay(vec2(pixel) + 0.5))
  {
    imageStore(pictureImage, pixel, March());
  }
}
