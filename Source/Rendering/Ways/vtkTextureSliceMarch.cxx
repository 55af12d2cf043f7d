// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSliceMarch.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkTextureObject.h"
#include "vtkTextureSliceOpenGL.h"
#include "vtkTextureSliceShader.h"
#include "vtkTextureSliceUniforms.h"

#include "TextureSliceCS.h"
#include "TextureSliceFS.h"

bool vtkTextureSliceMarch::ReadyFragments(
  vtkOpenGLRenderWindow* window, const vtkTextureSliceUniforms& uniforms)
{
  const std::string defines = uniforms.Features.GetDefines();
  this->Program = this->Box.Ready(
    window, defines, [&defines] { return vtkTextureSliceShader::Make(TextureSliceFS, defines); });
  return this->Program != nullptr;
}

bool vtkTextureSliceMarch::ReadyCompute(
  vtkOpenGLRenderWindow* window, const vtkTextureSliceUniforms& uniforms)
{
  const std::string defines = uniforms.Features.GetDefines();
  this->Program = this->Compute.Ready(
    window, defines, [&defines] { return vtkTextureSliceShader::Make(TextureSliceCS, defines); });
  return this->Program != nullptr;
}

void vtkTextureSliceMarch::DrawFragments(
  vtkOpenGLRenderWindow* window, const vtkTextureSliceUniforms& uniforms)
{
  window->GetState()->vtkglDisable(GL_BLEND);
  uniforms.Use(this->Program, [&] { this->Box.Draw(*uniforms.Frame, uniforms.Seen); });
}

void vtkTextureSliceMarch::DrawCompute(
  const vtkTextureSliceUniforms& uniforms, vtkTextureObject* picture)
{
  const auto pixels = vtkTextureSliceCompute::FindPixels(*uniforms.Frame, uniforms.Seen,
    {static_cast<int>(picture->GetWidth()), static_cast<int>(picture->GetHeight())});
  uniforms.Use(this->Program, [&] { this->Compute.Dispatch(picture, pixels); });
}

void vtkTextureSliceMarch::ReleaseGraphicsResources(vtkOpenGLRenderWindow* window)
{
  this->Box.ReleaseGraphicsResources();
  this->Compute.ReleaseGraphicsResources(window);
  this->Program = nullptr;
}
