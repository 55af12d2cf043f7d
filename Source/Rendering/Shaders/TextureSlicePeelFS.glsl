#ifdef TEXTURE_SLICE_PEEL
// Depth peeling: between which depths of the window a pixel's part of the volume lies. The textures
// have the names that VTK's pass gives them. Each has a negative nearest depth and a farthest depth;
// -1 stands for none.

// Whether the picture is that of what lies in front of the geometry that is left.
uniform int peelInFront;

const vec2 nothing = vec2(3.0, -3.0);
const float nearest = -2.0;
const float farthest = 2.0;

vec2 FetchPeel(sampler2D depths)
{
  return texelFetch(depths, windowPixel, 0).xy;
}

#if TEXTURE_SLICE_PEEL == TEXTURE_SLICE_PEEL_REST
uniform sampler2D depthRangeTex;

vec2 PeelRange()
{
  vec2 left = FetchPeel(depthRangeTex);
  return left.x == -1.0 ? nothing : vec2(-left.x, left.y);
}
#else
// The last geometry that was peeled; at first, the opaque geometry.
uniform sampler2D outerDepthTex;
// The geometry to be peeled next.
uniform sampler2D innerDepthTex;

#if TEXTURE_SLICE_PEEL == TEXTURE_SLICE_PEEL_OUTSIDE
vec2 PeelRange()
{
  vec2 outer = FetchPeel(outerDepthTex);
  vec2 inner = FetchPeel(innerDepthTex);
  bool translucent = inner.x != -1.0;
  float opaqueDepth = outer.y < 0.0 ? farthest : outer.y;
  if (peelInFront != 0)
  {
    return translucent ? vec2(nearest, -inner.x) : nothing;
  }
  return vec2(translucent ? inner.y : nearest, opaqueDepth);
}
#else
vec2 PeelRange()
{
  vec2 outer = FetchPeel(outerDepthTex);
  vec2 inner = FetchPeel(innerDepthTex);
  if (outer.x == -1.0)
  {
    return nothing;
  }
  bool last = inner.x == -1.0;
  if (peelInFront != 0)
  {
    return vec2(-outer.x, last ? outer.y : -inner.x);
  }
  return last ? nothing : vec2(inner.y, outer.y);
}
#endif
#endif
#endif
