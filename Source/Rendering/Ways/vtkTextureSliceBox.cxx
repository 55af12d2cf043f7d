// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSliceBox.h"

#include "vtkMatrix4x4.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkOpenGLVertexArrayObject.h"
#include "vtkShaderProgram.h"
#include "vtkTextureSliceFrame.h"
#include "vtkTextureSliceOpenGL.h"

#include "TextureSliceBoxVS.h"

vtkTextureSliceBox::vtkTextureSliceBox() = default;
vtkTextureSliceBox::~vtkTextureSliceBox() = default;

vtkShaderProgram* vtkTextureSliceBox::Ready(vtkOpenGLRenderWindow* window, const std::string& key,
  const std::function<std::string()>& makeShader)
{
  vtkOpenGLShaderCache* cache = window->GetShaderCache();
  this->Window = window;
  if (this->Program == nullptr || key != this->Key)
  {
    this->Program = cache->ReadyShaderProgram(TextureSliceBoxVS, makeShader().c_str(), "");
    this->Key = key;
    return this->Program;
  }
  return cache->ReadyShaderProgram(this->Program);
}

void vtkTextureSliceBox::Draw(
  const vtkTextureSliceFrame& frame, const std::array<double, 6>& seen, int times)
{
  vtkMatrix4x4* boxToClip = frame.GetBoxToClip();
  std::array<float, 3> low{};
  std::array<float, 3> high{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    low[axis] = static_cast<float>(seen[2 * axis]);
    high[axis] = static_cast<float>(seen[2 * axis + 1]);
  }
  this->Program->SetUniformMatrix("boxToClip", boxToClip);
  this->Program->SetUniform3f("seenLow", low.data());
  this->Program->SetUniform3f("seenHigh", high.data());
  vtkOpenGLState* state = this->Window->GetState();
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglEnable(GL_CULL_FACE);
  // A matrix that mirrors turns the triangles round.
  state->vtkglCullFace(boxToClip->Determinant() < 0.0 ? GL_FRONT : GL_BACK);
  // Faces beyond the far plane count as well.
  glEnable(GL_DEPTH_CLAMP);
  this->VertexArray->Bind();
  glDrawArraysInstanced(GL_TRIANGLES, 0, 36, times);
  this->VertexArray->Release();
  glDisable(GL_DEPTH_CLAMP);
}

void vtkTextureSliceBox::ReleaseGraphicsResources()
{
  this->VertexArray->ReleaseGraphicsResources();
  this->Program = nullptr;
}
