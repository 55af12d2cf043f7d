// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSliceScreen.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLVertexArrayObject.h"
#include "vtkShaderProgram.h"
#include "vtkTextureSliceOpenGL.h"

#include "TextureSliceScreenVS.h"

vtkTextureSliceScreen::vtkTextureSliceScreen() = default;
vtkTextureSliceScreen::~vtkTextureSliceScreen() = default;

vtkShaderProgram* vtkTextureSliceScreen::Ready(vtkOpenGLRenderWindow* window,
  const std::string& key, const std::function<std::string()>& makeShader)
{
  vtkOpenGLShaderCache* cache = window->GetShaderCache();
  if (this->Program == nullptr || key != this->Key)
  {
    this->Program = cache->ReadyShaderProgram(TextureSliceScreenVS, makeShader().c_str(), "");
    this->Key = key;
    return this->Program;
  }
  return cache->ReadyShaderProgram(this->Program);
}

void vtkTextureSliceScreen::Draw()
{
  this->VertexArray->Bind();
  glDrawArrays(GL_TRIANGLES, 0, 3);
  this->VertexArray->Release();
}

void vtkTextureSliceScreen::ReleaseGraphicsResources()
{
  this->VertexArray->ReleaseGraphicsResources();
  this->Program = nullptr;
}
