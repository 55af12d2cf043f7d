// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSliceProgram.h"

#include "vtkMatrix4x4.h"
#include "vtkOpenGLBufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLVertexArrayObject.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"
#include "vtkTextureSliceGeometry.h"
#include "vtkTextureSliceOpenGL.h"

#include "TextureSliceFS.h"
#include "TextureSliceVS.h"

#include <string>

namespace
{

void SetUniforms(vtkShaderProgram* program, const vtkTextureSliceUniforms& uniforms)
{
  program->SetUniformMatrix("boxToClip", uniforms.BoxToClip);
  program->SetUniform3f("textureScale", uniforms.TextureScale.data());
  program->SetUniform3f("textureBias", uniforms.TextureBias.data());
  program->SetUniformi("volumeTexture", uniforms.Volume->GetTextureUnit());
  program->SetUniformi("transferTable", uniforms.Table->GetTextureUnit());
  program->SetUniformf("tableScale", static_cast<float>(uniforms.TableScale));
  program->SetUniformf("tableBias", static_cast<float>(uniforms.TableBias));
  program->SetUniformf("inverseUnitDistance", static_cast<float>(1.0 / uniforms.UnitDistance));
  if (uniforms.CropTest)
  {
    program->SetUniform3f("cropLow", uniforms.CropLow.data());
    program->SetUniform3f("cropHigh", uniforms.CropHigh.data());
    program->SetUniformi("cropFlags", uniforms.CropFlags);
  }
}

} // namespace

vtkTextureSliceProgram::vtkTextureSliceProgram()
{
  this->Vertices->SetType(vtkOpenGLBufferObject::ArrayBuffer);
}

vtkTextureSliceProgram::~vtkTextureSliceProgram() = default;

vtkShaderProgram* vtkTextureSliceProgram::Ready(
  vtkOpenGLRenderWindow* window, const vtkTextureSliceUniforms& uniforms)
{
  std::string defines;
  defines += uniforms.Masked ? "#define TEXTURE_SLICE_MASKED\n" : "";
  defines += uniforms.CropTest ? "#define TEXTURE_SLICE_CROPPED\n" : "";
  std::string fragmentShader = TextureSliceFS;
  vtkShaderProgram::Substitute(fragmentShader, "//VTK::TextureSlice::Defines", defines);
  return window->GetShaderCache()->ReadyShaderProgram(TextureSliceVS, fragmentShader.c_str(), "");
}

bool vtkTextureSliceProgram::Upload(
  vtkShaderProgram* program, const vtkTextureSliceGeometry& geometry)
{
  constexpr auto stride = sizeof(float) * vtkTextureSliceGeometry::FloatsPerVertex;
  this->VertexArray->Bind();
  if (!this->Vertices->Upload(geometry.GetVertices(), vtkOpenGLBufferObject::ArrayBuffer))
  {
    return false;
  }
  if (program == this->Program)
  {
    return true;
  }
  this->VertexArray->ShaderProgramChanged();
  this->VertexArray->Bind();
  const bool added = this->VertexArray->AddAttributeArray(
                       program, this->Vertices, "boxPosition", 0, stride, VTK_FLOAT, 3, false) &&
                     this->VertexArray->AddAttributeArray(program, this->Vertices, "rayStep",
                       3 * sizeof(float), stride, VTK_FLOAT, 3, false);
  this->Program = added ? program : nullptr;
  return added;
}

bool vtkTextureSliceProgram::Draw(vtkOpenGLRenderWindow* window,
  const vtkTextureSliceGeometry& geometry, const vtkTextureSliceUniforms& uniforms)
{
  vtkShaderProgram* program = this->Ready(window, uniforms);
  if (program == nullptr || !this->Upload(program, geometry))
  {
    return false;
  }
  uniforms.Volume->Activate();
  uniforms.Table->Activate();
  SetUniforms(program, uniforms);
  glDrawArrays(GL_TRIANGLES, 0, geometry.GetNumberOfVertices());
  this->VertexArray->Release();
  this->Vertices->Release();
  uniforms.Table->Deactivate();
  uniforms.Volume->Deactivate();
  return true;
}

void vtkTextureSliceProgram::ReleaseGraphicsResources()
{
  this->VertexArray->ReleaseGraphicsResources();
  this->Vertices->ReleaseGraphicsResources();
  this->Program = nullptr;
}
