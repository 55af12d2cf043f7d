//VTK::System::Dec
// SPDX-License-Identifier: BSD-3-Clause
// A corner of a slice: from the volume's box (0 to 1 along each axis) to the screen and the texture.

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

void main()
{
  gl_Position = boxToClip * vec4(boxPosition, 1.0);
  sliceCoordinate = boxPosition * textureScale + textureBias;
  sampleStep = rayStep * inverseUnitDistance;
  partPosition = (boxPosition - partMiddle) * partScale;
  partStep = rayStep * stepToPart;
}
