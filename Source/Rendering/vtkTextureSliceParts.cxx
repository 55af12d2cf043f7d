// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSliceParts.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkTextureSliceOpenGL.h"
#include "vtkVolumeMapper.h"

#include <algorithm>

bool vtkTextureSliceParts::IsNews(std::string& last, const std::string& message)
{
  const bool news = last != message;
  last = message;
  return news && !message.empty();
}

void vtkTextureSliceParts::Release(vtkOpenGLRenderWindow* window)
{
  if (window == nullptr)
  {
    return;
  }
  window->PushContext();
  this->Texture.ReleaseGraphicsResources(window);
  this->Table.ReleaseGraphicsResources(window);
  this->Table2D.ReleaseGraphicsResources(window);
  this->Mask.ReleaseGraphicsResources(window);
  this->SecondArray.ReleaseGraphicsResources(window);
  this->Blanks.ReleaseGraphicsResources(window);
  this->Coordinates.ReleaseGraphicsResources(window);
  this->LabelTable.ReleaseGraphicsResources(window);
  this->Shadows.ReleaseGraphicsResources(window);
  this->Integrals.ReleaseGraphicsResources(window);
  this->LabelIntegrals.ReleaseGraphicsResources(window);
  this->Target.ReleaseGraphicsResources(window);
  this->Ways.ReleaseGraphicsResources(window);
  this->EmptySpace.GetDistances().ReleaseGraphicsResources(window);
  window->PopContext();
  this->Window = nullptr;
}

void vtkTextureSliceParts::Use(vtkOpenGLRenderWindow* window)
{
  if (this->Window != window)
  {
    this->Release(this->Window);
  }
  this->Window = window;
  window->MakeCurrent();
}

bool vtkTextureSliceParts::UpdateTables(
  const vtkTextureSliceRequest& request, bool nearest, std::string& error)
{
  const auto& components = this->Texture.GetComponents();
  const vtkTextureSliceFeatures features = request.GetFeatures();
  this->Table.Update(this->Window, request.MakeRows(components), nearest);
  if (features.Labels > 0)
  {
    this->LabelTable.Update(this->Window, request.MakeLabelRows(components), nearest);
  }
  return !features.Table2D ||
         this->Table2D.Update(this->Window, request.MakeTables2D(), nearest, error);
}

void vtkTextureSliceParts::AddTextures(vtkTextureSliceUniforms& uniforms)
{
  const vtkTextureSliceFeatures& features = uniforms.Features;
  const auto add = [&uniforms](bool needed, const char* sampler, vtkTextureObject* texture)
  {
    if (needed)
    {
      uniforms.Textures.emplace_back(sampler, texture);
    }
  };
  add(true, "volumeTexture", this->Texture.GetTexture());
  add(true, "transferTable", this->Table.GetTexture());
  add(features.Table2D, "transferTable2D", this->Table2D.GetTexture());
  add(features.Rectilinear, "coordinateTable", this->Coordinates.GetTexture());
  add(features.SecondArray > 0, "secondTexture", this->SecondArray.GetTexture());
  add(features.Blanked, "blankTexture", this->Blanks.GetTexture());
  add(features.HasMask(), "maskTexture", this->Mask.GetTexture());
  add(features.Labels > 0, "labelTable", this->LabelTable.GetTexture());
  add(features.Shadows, "lightTexture", this->Shadows.GetTexture());
  add(features.NeedsDepth(), "geometryDepth", this->Target.GetGeometryDepth());
  add(features.Skipping, "distanceMap", this->EmptySpace.GetDistances().GetTexture());
  add(features.Slabs, "integralTable", this->Integrals.GetTexture());
  add(
    features.Slabs && features.Labels > 0, "labelIntegralTable", this->LabelIntegrals.GetTexture());
}

void vtkTextureSliceParts::SetUniforms(
  const vtkTextureSliceFeatures& features, vtkShaderProgram* program)
{
  this->Table.SetUniforms("table", program);
  this->Blanks.SetUniforms(program);
  this->EmptySpace.GetDistances().SetUniforms(program, this->Frame);
  if (features.Labels > 0)
  {
    this->LabelTable.SetUniforms("labelTable", program);
  }
  if (features.Table2D)
  {
    program->SetUniformf("table2DRows", static_cast<float>(this->Table2D.GetNumberOfRows()));
  }
  if (features.Rectilinear)
  {
    this->Coordinates.SetUniforms(program);
  }
  if (features.SecondArray > 0)
  {
    vtkTextureSliceRequest::SetSecondArray(this->SecondArray.GetComponents(), program);
  }
  if (features.Lights >= 0)
  {
    this->Lights.SetUniforms(program, this->Frame);
  }
  if (features.Shadows)
  {
    this->Shadows.SetUniforms(program);
  }
  if (features.Peel > 0)
  {
    this->Peeling.SetUniforms(program);
  }
  if (features.Slabs)
  {
    program->SetUniformi("slabsOfPiece", vtkTextureSliceFeatures::SlabsOfPiece);
    this->Integrals.SetUniforms("lastIntegral", program);
    this->LabelIntegrals.SetUniforms("lastLabelIntegral", program);
  }
}

void vtkTextureSliceParts::UpdateIntegrals(const vtkTextureSliceUniforms& uniforms)
{
  const vtkTextureSliceFeatures& features = uniforms.Features;
  double unitDistance = 0.0; // the longest
  for (const vtkTextureSliceSurface& surface : uniforms.Surfaces)
  {
    unitDistance = std::max(unitDistance, 1.0 / static_cast<double>(surface.InverseUnitDistance));
  }
  const double slab = this->Planes.GetDataStep();
  const double mostDepth = vtkTextureSliceIntegralTable::ChooseMostDepth(slab / unitDistance);
  const int dimensions = features.GetIntegralDimensions();
  this->Integrals.Update(this->Window, this->Table, features.Functions, dimensions, mostDepth);
  if (features.Labels > 0)
  {
    this->LabelIntegrals.Update(
      this->Window, this->LabelTable, features.Labels, dimensions, mostDepth);
  }
}

bool vtkTextureSliceParts::Draw(const vtkTextureSliceUniforms& uniforms, std::string& error)
{
  const vtkTextureSliceFeatures& features = uniforms.Features;
  if (!this->Ways.Choose(this->Window, uniforms))
  {
    error = "OpenGL could not compile the shaders of the slices";
    return false;
  }
  if (!this->Target.Begin(this->Window, this->PixelSize, features.NeedsDepth(),
        this->Ways.NeedsFullPrecision(), error))
  {
    return false;
  }
  if (features.Slabs)
  {
    this->UpdateIntegrals(uniforms);
  }
  if (features.Skipping)
  {
    this->EmptySpace.GetDistances().Upload(this->Window);
  }
  this->Ways.Draw(this->Window, uniforms, this->Target.GetPicture());
  this->Target.End();
  return true;
}

void vtkTextureSliceParts::Composite(
  const vtkTextureSliceUniforms& uniforms, float colorScale, float colorBias)
{
  // Associated colour over the window; identifiers as they are.
  vtkOpenGLState* state = this->Window->GetState();
  state->vtkglBlendEquation(GL_FUNC_ADD);
  state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  state->SetEnumState(GL_BLEND, !uniforms.Features.Selection);
  const bool peeled = uniforms.Features.Peel > 0;
  if (peeled)
  {
    this->Peeling.SetBlending(state);
  }
  // Between an extreme and no sample at all there is nothing.
  const int blendMode = uniforms.Features.BlendMode;
  const bool smooth = this->PixelSize != 1.0 &&
                      blendMode != vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND &&
                      blendMode != vtkVolumeMapper::MINIMUM_INTENSITY_BLEND;
  this->Target.Composite(smooth, uniforms,
    [&](vtkShaderProgram* program)
    {
      if (peeled)
      {
        this->Peeling.SetUniforms(program);
      }
      program->SetUniformf("colorScale", colorScale);
      program->SetUniformf("colorBias", colorBias);
      program->SetUniform3f("selectionColor", uniforms.SelectionColor.data());
    });
}
