// Depth peeling: the pass has a texture of what is behind the geometry that is left, and one of what is
// in front of it. Only peeled volumes have this code, since a second output must have a texture.
// Whether the picture is that of what lies in front of the geometry that is left.
uniform int peelInFront;
#if TEXTURE_SLICE_PEEL == TEXTURE_SLICE_PEEL_BETWEEN
// What was peeled from the front so far.
uniform sampler2D lastFrontColorTex;
#endif

void main()
{
  vec4 color = FinalColor();
  vec4 before = vec4(0.0);
#if TEXTURE_SLICE_PEEL == TEXTURE_SLICE_PEEL_BETWEEN
  before = texelFetch(lastFrontColorTex, ivec2(gl_FragCoord.xy), 0);
#endif
  bool inFront = peelInFront != 0;
  gl_FragData[0] = inFront ? vec4(0.0) : color;
  gl_FragData[1] = inFront ? before + (1.0 - before.a) * color : before;
}
