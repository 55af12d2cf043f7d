// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSliceOpaquePixels.h"

#include "vtkMatrix4x4.h"
#include "vtkOpenGLBufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkOpenGLVertexArrayObject.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"
#include "vtkTextureSliceGeometry.h"
#include "vtkTextureSliceOpenGL.h"

#include "TextureSliceOpaqueFS.h"
#include "TextureSliceVS.h"

#include <algorithm>
#include <cmath>

vtkTextureSliceOpaquePixels::vtkTextureSliceOpaquePixels() = default;
vtkTextureSliceOpaquePixels::~vtkTextureSliceOpaquePixels() = default;

int vtkTextureSliceOpaquePixels::ChooseGroup(double mostOpacity, int slices)
{
  constexpr double least = 16.0;
  if (mostOpacity <= 0.0)
  {
    return 0;
  }
  const double needed =
    mostOpacity < Opaque ? std::log(1.0 - Opaque) / std::log(1.0 - mostOpacity) : 1.0;
  return needed < 0.5 * slices ? static_cast<int>(std::max(least, std::ceil(needed))) : 0;
}

bool vtkTextureSliceOpaquePixels::Connect(
  vtkShaderProgram* program, vtkOpenGLBufferObject* vertices)
{
  this->VertexArray->Bind();
  if (program == this->Program)
  {
    return true;
  }
  this->VertexArray->ShaderProgramChanged();
  this->VertexArray->Bind();
  const bool connected = this->VertexArray->AddAttributeArray(program, vertices, "boxPosition", 0,
    sizeof(float) * vtkTextureSliceGeometry::FloatsPerVertex, VTK_FLOAT, 3, false);
  this->Program = connected ? program : nullptr;
  return connected;
}

bool vtkTextureSliceOpaquePixels::Mark(vtkOpenGLRenderWindow* window,
  vtkOpenGLBufferObject* vertices, int first, int count, vtkMatrix4x4* boxToClip,
  vtkTextureObject* picture)
{
  vtkShaderProgram* program =
    window->GetShaderCache()->ReadyShaderProgram(TextureSliceVS, TextureSliceOpaqueFS, "");
  if (program == nullptr || !this->Connect(program, vertices))
  {
    return false;
  }
  picture->Activate();
  program->SetUniformMatrix("boxToClip", boxToClip);
  program->SetUniformi("volumeImage", picture->GetTextureUnit());
  program->SetUniformf("opaque", static_cast<float>(Opaque));
  vtkOpenGLState* state = window->GetState();
  state->vtkglDepthMask(GL_TRUE);
  state->vtkglDepthFunc(GL_LESS); // passes by what is marked already
  glDepthRange(0.0, 0.0);
  glDrawArrays(GL_TRIANGLES, first, count);
  glDepthRange(0.0, 1.0);
  state->vtkglDepthFunc(GL_LEQUAL);
  state->vtkglDepthMask(GL_FALSE);
  picture->Deactivate();
  this->VertexArray->Release();
  return true;
}

void vtkTextureSliceOpaquePixels::ReleaseGraphicsResources()
{
  this->VertexArray->ReleaseGraphicsResources();
  this->Program = nullptr;
}
