//VTK::System::Dec
// SPDX-License-Identifier: BSD-3-Clause
// Hands the finished volume (associated colour) to the window, with the final window and level.
//VTK::Output::Dec

//VTK::TextureSlice::Defines

// From a pixel of the window to the picture: scale and bias.
uniform vec4 toPicture;

uniform sampler2D volumeImage;
uniform float colorScale;
uniform float colorBias;

#ifdef TEXTURE_SLICE_SELECTION
uniform vec3 selectionColor;
#endif

#ifdef TEXTURE_SLICE_PEEL
// Depth peeling: whether the picture is that of what lies in front of the geometry that is left.
uniform int peelInFront;
#if TEXTURE_SLICE_PEEL == TEXTURE_SLICE_PEEL_BETWEEN
// What was peeled from the front so far.
uniform sampler2D lastFrontColorTex;
#endif
#endif

void main()
{
  vec4 color = texture(volumeImage, gl_FragCoord.xy * toPicture.xy + toPicture.zw);
#ifdef TEXTURE_SLICE_SELECTION
  // As in VTK's ray caster, what is fainter cannot be picked.
  if (color.a <= 3.0 / 255.0)
  {
    discard;
  }
  gl_FragData[0] = vec4(selectionColor, 1.0);
#else
  color.rgb = color.rgb * colorScale + colorBias * color.a;
#ifdef TEXTURE_SLICE_PEEL
  vec4 before = vec4(0.0);
#if TEXTURE_SLICE_PEEL == TEXTURE_SLICE_PEEL_BETWEEN
  before = texelFetch(lastFrontColorTex, ivec2(gl_FragCoord.xy), 0);
#endif
  gl_FragData[1] = peelInFront != 0 ? before + (1.0 - before.a) * color : before;
  color = peelInFront != 0 ? vec4(0.0) : color;
#endif
  gl_FragData[0] = color;
#endif
}
