// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSliceParts.h"

#include "vtkImageData.h"
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
  for (vtkTextureObject* texture : {this->Texture.GetTexture(), this->Table.GetTexture(),
         this->Table2D.GetTexture(), this->Mask.GetTexture(), this->SecondArray.GetTexture(),
         this->Blanks.GetTexture(), this->Coordinates.GetTexture(), this->LabelTable.GetTexture(),
         this->Shadows.GetTexture(), this->Integrals.GetTexture(),
         this->LabelIntegrals.GetTexture(), this->EmptySpace.GetDistances().GetTexture()})
  {
    texture->ReleaseGraphicsResources(window);
  }
  this->Target.ReleaseGraphicsResources(window);
  this->Ways.ReleaseGraphicsResources(window);
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

bool vtkTextureSliceParts::UpdateVolume(bool cellData, vtkDataArray* second, std::string& error)
{
  // As in VTK's ray caster, "nearest" holds for the tables as well as for the volume.
  const bool nearest = this->Request.IsNearest();
  if (this->Coordinates.IsUsed())
  {
    this->Coordinates.Update(this->Window);
  }
  auto source = vtkTextureSliceScalars::Find(this->Image, this->Scalars, cellData);
  source.Places = this->Coordinates.GetPlaces();
  return this->Texture.Update(this->Window, source, nearest, error) &&
         this->Blanks.Update(this->Window, this->Image, cellData, error) &&
         (second == nullptr ||
           this->SecondArray.Update(this->Window,
             vtkTextureSliceScalars::Find(this->Image, second, cellData), nearest, error)) &&
         this->UpdateTables(nearest, error);
}

bool vtkTextureSliceParts::UpdateTables(bool nearest, std::string& error)
{
  const auto& components = this->Texture.GetComponents();
  const vtkTextureSliceFeatures features = this->Request.GetFeatures();
  this->Table.Update(this->Window, this->Request.MakeRows(components), nearest);
  if (features.Labels > 0)
  {
    this->LabelTable.Update(this->Window, this->Request.MakeLabelRows(components), nearest);
  }
  return !features.Table2D ||
         this->Table2D.Update(this->Window, this->Request.MakeTables2D(), nearest, error);
}

void vtkTextureSliceParts::UpdateIntegrals()
{
  double unitDistance = 0.0; // the longest
  for (const vtkTextureSliceSurface& surface : this->Surfaces)
  {
    unitDistance = std::max(unitDistance, 1.0 / static_cast<double>(surface.InverseUnitDistance));
  }
  const double slab = this->Planes.GetDataStep();
  const double mostDepth = vtkTextureSliceIntegralTable::ChooseMostDepth(slab / unitDistance);
  const int dimensions = this->Features.GetIntegralDimensions();
  this->Integrals.Update(
    this->Window, this->Table, this->Features.Functions, dimensions, mostDepth);
  if (this->Features.Labels > 0)
  {
    this->LabelIntegrals.Update(
      this->Window, this->LabelTable, this->Features.Labels, dimensions, mostDepth);
  }
}

bool vtkTextureSliceParts::Draw(std::string& error)
{
  if (!this->Ways.Choose(this->Window, *this))
  {
    error = "OpenGL could not compile the shaders of the slices";
    return false;
  }
  if (!this->Target.Begin(this->Window, this->PixelSize, this->Features.NeedsDepth(),
        this->Ways.NeedsFullPrecision() || this->Features.Places, error))
  {
    return false;
  }
  if (this->Features.Slabs)
  {
    this->UpdateIntegrals();
  }
  if (this->Features.Skipping)
  {
    this->EmptySpace.GetDistances().Upload(this->Window);
  }
  this->Ways.Draw(this->Window, *this, this->Target.GetPicture());
  this->Target.End();
  return true;
}

void vtkTextureSliceParts::Composite(float colorScale, float colorBias)
{
  // Associated colour over the window; identifiers as they are.
  vtkOpenGLState* state = this->Window->GetState();
  state->vtkglBlendEquation(GL_FUNC_ADD);
  state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  state->SetEnumState(GL_BLEND, !this->Features.Selection);
  const bool peeled = this->Features.Peel > 0;
  if (peeled)
  {
    this->Peeling.SetBlending(state);
  }
  // Between an extreme and no sample at all there is nothing.
  const int blendMode = this->Features.BlendMode;
  const bool smooth = this->PixelSize != 1.0 &&
                      blendMode != vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND &&
                      blendMode != vtkVolumeMapper::MINIMUM_INTENSITY_BLEND;
  this->Target.Composite(smooth, *this,
    [&](vtkShaderProgram* program)
    {
      if (peeled)
      {
        this->Peeling.SetUniforms(program);
      }
      program->SetUniformf("colorScale", colorScale);
      program->SetUniformf("colorBias", colorBias);
      program->SetUniform3f("selectionColor", this->SelectionColor.data());
    });
}
