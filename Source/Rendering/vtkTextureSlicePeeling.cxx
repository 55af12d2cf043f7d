// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSlicePeeling.h"

#include "vtkAbstractMapper.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkOpenGLRenderPass.h"
#include "vtkOpenGLState.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkTextureSliceOpenGL.h"
#include "vtkVolume.h"

#include <string>

namespace
{

/// Where the pass declares its textures in the shader of VTK's ray caster.
const std::string Declarations = "//VTK::DepthPeeling::Dec";

/// What a pass declares at the present stage; Declarations itself if it does not peel volumes.
std::string Declare(vtkOpenGLRenderPass* pass, vtkAbstractMapper* mapper, vtkVolume* volume)
{
  std::string vertexShader;
  std::string geometryShader;
  std::string fragmentShader = Declarations;
  pass->PreReplaceShaderValues(vertexShader, geometryShader, fragmentShader, mapper, volume);
  return fragmentShader;
}

/// The stage is known to the pass alone, but each one declares other textures.
vtkTextureSlicePeeling::Stage FindStage(const std::string& declared)
{
  const auto declares = [&declared](const char* name)
  { return declared.find(name) != std::string::npos; };
  return declares("depthRangeTex")       ? vtkTextureSlicePeeling::Rest
         : !declares("innerDepthTex")    ? vtkTextureSlicePeeling::None
         : declares("lastFrontColorTex") ? vtkTextureSlicePeeling::Between
                                         : vtkTextureSlicePeeling::Outside;
}

/// VTK's pass takes all that is translucent for hidden where a pixel has several samples. Passes of
/// the renderer's own draw into pictures without them.
const char* FindUnsupported(vtkRenderer* renderer)
{
  return renderer->GetPass() == nullptr && renderer->GetRenderWindow()->GetMultiSamples() > 0
           ? "VTK's depth peeling draws nothing in a window with multisamples: call "
             "SetMultiSamples(0) on the window"
           : nullptr;
}

} // namespace

const char* vtkTextureSlicePeeling::Update(
  vtkRenderer* renderer, vtkAbstractMapper* mapper, vtkVolume* volume)
{
  this->Asked = None;
  this->Picture = 0;
  this->Mapper = mapper;
  this->Volume = volume;
  vtkInformation* keys = volume->GetPropertyKeys();
  vtkInformationObjectBaseVectorKey* passes = vtkOpenGLRenderPass::RenderPasses();
  const int count = keys != nullptr && keys->Has(passes) ? passes->Length(keys) : 0;
  for (int i = 0; i < count; ++i)
  {
    auto* pass = vtkOpenGLRenderPass::SafeDownCast(passes->Get(keys, i));
    const std::string declared = pass != nullptr ? Declare(pass, mapper, volume) : Declarations;
    if (declared != Declarations)
    {
      this->Pass = pass;
      this->Asked = FindStage(declared);
      return this->Asked == None
               ? "a render pass peels the volume in a way that is not known: call "
                 "SetUseDepthPeelingForVolumes(false) on the renderer"
               : FindUnsupported(renderer);
    }
  }
  return nullptr;
}

void vtkTextureSlicePeeling::SetUniforms(vtkShaderProgram* program) const
{
  this->Pass->SetShaderParameters(program, this->Mapper, this->Volume);
  program->SetUniformi("peelInFront", this->CountPictures() == 2 && this->Picture == 0 ? 1 : 0);
}

void vtkTextureSlicePeeling::SetBlending(vtkOpenGLState* state) const
{
  // As the pass itself: where a volume draws nothing, the largest of nothing and what is there
  // leaves it alone.
  if (this->Asked == Rest)
  {
    state->vtkglBlendEquation(GL_FUNC_ADD);
    state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  }
  else
  {
    state->vtkglBlendEquation(GL_MAX);
  }
}
