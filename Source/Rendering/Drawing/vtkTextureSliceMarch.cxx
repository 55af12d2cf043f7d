// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSliceMarch.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"
#include "vtkTextureSliceOpenGL.h"
#include "vtkTextureSlicePlanes.h"
#include "vtkTextureSliceUniforms.h"

#include "TextureSliceColoringFS.h"
#include "TextureSliceFS.h"
#include "TextureSliceLightingFS.h"
#include "TextureSliceMarchFS.h"
#include "TextureSlicePeelFS.h"
#include "TextureSliceRayFS.h"
#include "TextureSliceSamplesFS.h"
#include "TextureSliceSamplingFS.h"
#include "TextureSliceShadowsFS.h"
#include "TextureSliceSkippingFS.h"
#include "TextureSliceSlabsFS.h"
#include "TextureSliceSurfacesFS.h"
#include "TextureSliceTableFS.h"

#include <algorithm>
#include <string>
#include <vector>

namespace
{

std::string MakeShader(const std::string& defines)
{
  std::string shader = TextureSliceFS;
  for (const auto& [place, text] : {std::pair("Defines", defines.c_str()),
         {"Ray", TextureSliceRayFS}, {"Peel", TextureSlicePeelFS},
         {"Sampling", TextureSliceSamplingFS}, {"Lighting", TextureSliceLightingFS},
         {"Shadows", TextureSliceShadowsFS}, {"Table", TextureSliceTableFS},
         {"Coloring", TextureSliceColoringFS}, {"Samples", TextureSliceSamplesFS},
         {"Slabs", TextureSliceSlabsFS}, {"Surfaces", TextureSliceSurfacesFS},
         {"Skipping", TextureSliceSkippingFS}, {"March", TextureSliceMarchFS}})
  {
    vtkShaderProgram::Substitute(shader, std::string("//VTK::TextureSlice::") + place, text);
  }
  return shader;
}

} // namespace

bool vtkTextureSliceMarch::Draw(
  vtkOpenGLRenderWindow* window, const vtkTextureSliceUniforms& uniforms)
{
  const std::string defines = uniforms.Features.GetDefines();
  vtkShaderProgram* program =
    this->Box.Ready(window, defines, [&defines] { return MakeShader(defines); });
  if (program == nullptr)
  {
    return false;
  }
  window->GetState()->vtkglDisable(GL_BLEND);
  const std::vector<vtkTextureObject*> textures = uniforms.GetTextures();
  std::for_each(textures.begin(), textures.end(), [](vtkTextureObject* t) { t->Activate(); });
  uniforms.Set(program);
  this->Box.Draw(*uniforms.Frame, uniforms.Seen);
  std::for_each(textures.rbegin(), textures.rend(), [](vtkTextureObject* t) { t->Deactivate(); });
  return true;
}
