// SPDX-License-Identifier: BSD-3-Clause
// A line as a rectangle of pixels: one instance for each segment, four corners each. It is half a pixel wider on each side
// than the line, for its soft edge.
in vec3 begin;
in vec3 end;

uniform mat4 toClip;
uniform vec2 pictureSize; // pixels
uniform float lineWidth; // pixels

out float beside; // pixels from the middle of the line

const float nearest = 1e-3; // w of clip coordinates at which a line is cut off

void main() {
  vec4 a = toClip * vec4(begin, 1.0);
  vec4 b = toClip * vec4(end, 1.0);
  if (max(a.w, b.w) < nearest) {
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0); // behind the camera
    return;
  }
  if (a.w < nearest) {
    a = mix(a, b, (nearest - a.w) / (b.w - a.w));
  }
  if (b.w < nearest) {
    b = mix(b, a, (nearest - b.w) / (a.w - b.w));
  }
  vec2 way = (b.xy / b.w - a.xy / a.w) * pictureSize;
  vec2 along = length(way) > 0.0 ? normalize(way) : vec2(1.0, 0.0);
  float side = (gl_VertexID & 1) == 0 ? -1.0 : 1.0;
  float lengthwise = gl_VertexID < 2 ? -1.0 : 1.0;
  float reach = 0.5 * lineWidth + 0.5;
  vec4 middle = gl_VertexID < 2 ? a : b;
  vec2 pixels = side * reach * vec2(-along.y, along.x) + lengthwise * 0.25 * lineWidth * along;
  beside = side * reach;
  gl_Position = vec4(middle.xy + 2.0 * pixels / pictureSize * middle.w, 0.0, middle.w);
}
