//VTK::System::Dec
// SPDX-License-Identifier: BSD-3-Clause
// A corner of a slice: from the volume's box (0 to 1 along each axis) to the screen and the texture.

// See vtkTextureSliceFeatures::GetDefines.
//VTK::TextureSlice::Defines

in vec3 boxPosition;
in vec3 rayStep;

uniform mat4 boxToClip;
uniform vec3 textureScale;
uniform vec3 textureBias;
uniform float inverseUnitDistance;

// From the box to the part of it that is drawn, -0.5 to 0.5 along each axis; rayStep likewise.
uniform vec3 partMiddle;
uniform vec3 partScale;
uniform vec3 stepToPart;

out vec3 sliceCoordinate;
out vec3 sampleStep;
out vec3 partPosition;
out vec3 partStep;

#ifdef TEXTURE_SLICE_SLABS
// z and w of the clip coordinates from one slice to the next.
uniform vec2 clipStep;
// z and w of the slice's clip coordinates.
flat out vec2 clipDepth;
#endif

void main()
{
  gl_Position = boxToClip * vec4(boxPosition, 1.0);
  sliceCoordinate = boxPosition * textureScale + textureBias;
  sampleStep = rayStep * inverseUnitDistance;
  partPosition = (boxPosition - partMiddle) * partScale;
  partStep = rayStep * stepToPart;
#ifdef TEXTURE_SLICE_SLABS
  // The depth test must pass where the nearest part of the fragment's segment is not hidden; the
  // fragment shader cuts the segment off at the depth of the opaque geometry.
  clipDepth = gl_Position.zw;
  vec2 nearEnd = clipDepth - clipStep;
  gl_Position.z =
    (nearEnd.y > 0.0 ? max(nearEnd.x / nearEnd.y, -1.0) : -1.0) * gl_Position.w;
#endif
}
