// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSliceParts.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkTextureSliceOpenGL.h"
#include "vtkVolumeMapper.h"

#include <algorithm>
#include <cmath>

namespace
{

/// What the target holds before the first slice.
float GetClearValue(int blendMode)
{
  // Extremes are 0 to 1: beyond that, there was no sample.
  switch (blendMode)
  {
  case vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND:
    return -1.0f;
  case vtkVolumeMapper::MINIMUM_INTENSITY_BLEND:
    return 2.0f;
  default:
    return 0.0f;
  }
}

/// How a slice joins those in front of it.
void SetBlending(vtkOpenGLState* state, int blendMode)
{
  switch (blendMode)
  {
  case vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND:
    state->vtkglBlendEquation(GL_MAX);
    break;
  case vtkVolumeMapper::MINIMUM_INTENSITY_BLEND:
    state->vtkglBlendEquation(GL_MIN);
    break;
  case vtkVolumeMapper::AVERAGE_INTENSITY_BLEND:
  case vtkVolumeMapper::ADDITIVE_BLEND:
    state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE);
    break;
  default:
    // Formulas T9, R3: associated colour, front to back.
    state->vtkglBlendFuncSeparate(GL_ONE_MINUS_DST_ALPHA, GL_ONE, GL_ONE_MINUS_DST_ALPHA, GL_ONE);
  }
}

/// The sample with the least depth takes a pixel, from a depth of 1 on.
void KeepNearest(vtkOpenGLState* state)
{
  state->vtkglDisable(GL_BLEND);
  state->vtkglDepthFunc(GL_LESS);
  state->vtkglDepthMask(GL_TRUE);
  state->vtkglClear(GL_DEPTH_BUFFER_BIT);
}

} // namespace

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
  this->Program.ReleaseGraphicsResources();
  this->OpaquePixels.ReleaseGraphicsResources();
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

void vtkTextureSliceParts::UpdateIntegrals(const vtkTextureSliceUniforms& uniforms)
{
  const vtkTextureSliceFeatures& features = uniforms.Features;
  double unitDistance = 0.0; // the longest
  for (const vtkTextureSliceSurface& surface : uniforms.Surfaces)
  {
    unitDistance = std::max(unitDistance, 1.0 / static_cast<double>(surface.InverseUnitDistance));
  }
  const double slab = this->Geometry.GetDataStep() / features.Slabs;
  const double mostDepth = vtkTextureSliceIntegralTable::ChooseMostDepth(slab / unitDistance);
  const int dimensions = features.GetIntegralDimensions();
  this->Integrals.Update(this->Window, this->Table, features.Functions, dimensions, mostDepth);
  if (features.Labels > 0)
  {
    this->LabelIntegrals.Update(
      this->Window, this->LabelTable, features.Labels, dimensions, mostDepth);
  }
}

int vtkTextureSliceParts::ChooseGroup(const vtkTextureSliceUniforms& uniforms)
{
  const vtkTextureSliceFeatures& features = uniforms.Features;
  const bool composite = features.BlendMode == vtkVolumeMapper::COMPOSITE_BLEND;
  if (!composite && features.BlendMode != vtkVolumeMapper::ISOSURFACE_BLEND)
  {
    return 0;
  }
  double mostOpacity = 0.0;
  for (int i = 0; i < features.Functions; ++i)
  {
    const auto row = static_cast<std::size_t>(i);
    const double steps =
      this->Geometry.GetDataStep() * double(uniforms.Surfaces[row].InverseUnitDistance);
    mostOpacity = std::max(
      mostOpacity, 1.0 - std::pow(1.0 - this->Table.GetMostOpacity(row), steps)); // Formulas R1
  }
  // Opacities that are not those of the table may be anything.
  const bool other = !composite || features.Table2D || features.Labels > 0;
  return vtkTextureSliceOpaquePixels::ChooseGroup(
    other ? 1.0 : mostOpacity, this->Geometry.GetNumberOfPlanes());
}

bool vtkTextureSliceParts::DrawSlices(const vtkTextureSliceUniforms& uniforms)
{
  const auto hideOpaque = [&](vtkOpenGLBufferObject* vertices, int first, int count)
  {
    this->Target.BeginDepthOnly();
    this->OpaquePixels.Mark(
      this->Window, vertices, first, count, this->Frame.GetBoxToClip(), this->Target.GetPicture());
    this->Target.EndDepthOnly();
  };
  const int vertices = this->Geometry.GetNumberOfVertices();
  // The farther back, the fewer pixels are left, and each look for opaque ones costs the same.
  constexpr int growth = 2;
  const bool drawn = vertices == 0 || this->Program.Draw(this->Window, this->Geometry, uniforms,
                                        {this->ChooseGroup(uniforms), growth}, hideOpaque);
  if (!drawn || !this->HasCover)
  {
    return drawn;
  }
  // Pixels that have a sum are passed by; elsewhere the first sample makes them black.
  if (vertices > 0)
  {
    hideOpaque(this->Program.GetVertices(), 0, vertices);
  }
  // A slice covers pixels that none before it did, so each group marks as many as the others.
  const int group = vtkTextureSliceOpaquePixels::ChooseGroup(1.0, this->Cover.GetNumberOfPlanes());
  return this->Program.Draw(this->Window, this->Cover, uniforms, {group, 1}, hideOpaque);
}

bool vtkTextureSliceParts::Draw(
  vtkRenderer* renderer, const vtkTextureSliceUniforms& uniforms, std::string& error)
{
  const int blendMode = uniforms.Features.BlendMode;
  if (!this->Target.Begin(renderer, GetClearValue(blendMode), this->PixelSize, error))
  {
    return false;
  }
  if (uniforms.Features.Slabs > 0)
  {
    this->UpdateIntegrals(uniforms);
  }
  if (uniforms.Features.NeedsDepth() && !this->Target.KeepDepth(error))
  {
    this->Target.End();
    return false;
  }
  vtkOpenGLState* state = this->Window->GetState();
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthFunc(GL_LEQUAL);
  state->vtkglDisable(GL_CULL_FACE);
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendEquation(GL_FUNC_ADD);
  SetBlending(state, blendMode);
  if (uniforms.Features.ExtremeSample)
  {
    KeepNearest(state);
  }
  const bool drawn = this->DrawSlices(uniforms);
  state->vtkglBlendEquation(GL_FUNC_ADD);
  this->Target.End();
  if (!drawn)
  {
    error = "OpenGL could not compile the shaders of the slices";
  }
  return drawn;
}

void vtkTextureSliceParts::Composite(
  vtkRenderer* renderer, const vtkTextureSliceUniforms& uniforms, float colorScale, float colorBias)
{
  // Associated colour over the window; identifiers as they are.
  vtkOpenGLState* state = this->Window->GetState();
  state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  state->SetEnumState(GL_BLEND, !uniforms.Features.Selection);
  const bool peeled = uniforms.Features.Peel > 0;
  if (peeled)
  {
    this->Peeling.SetBlending(state);
  }
  this->Table.GetTexture()->Activate();
  // Between an extreme and no sample at all there is nothing.
  const int blendMode = uniforms.Features.BlendMode;
  const bool smooth = this->PixelSize != 1.0 &&
                      blendMode != vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND &&
                      blendMode != vtkVolumeMapper::MINIMUM_INTENSITY_BLEND;
  this->Target.Composite(renderer, smooth, uniforms.Features,
    [&](vtkShaderProgram* program)
    {
      if (peeled)
      {
        this->Peeling.SetUniforms(program, 1.0);
      }
      program->SetUniformf("colorScale", colorScale);
      program->SetUniformf("colorBias", colorBias);
      program->SetUniform3f("selectionColor", uniforms.SelectionColor.data());
      uniforms.SetTable(program);
    });
  this->Table.GetTexture()->Deactivate();
}
