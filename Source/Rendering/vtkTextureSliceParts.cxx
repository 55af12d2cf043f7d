// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSliceParts.h"

#include "vtkImageData.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLTextureSliceVolumeMapper.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <cmath>

namespace
{

/// Columns of a matrix that takes a pixel to a place, or with a bias of 0 a way, in the texture.
std::array<float, 9> ToTexture(const vtkTextureSlicePixelMap& map,
  const std::array<float, 3>& scale, const std::array<float, 3>& bias)
{
  std::array<float, 9> columns{};
  for (std::size_t i = 0; i < 9; ++i)
  {
    const double place = map[i / 3][i % 3] * static_cast<double>(scale[i % 3]);
    columns[i] = static_cast<float>(i < 6 ? place : place + static_cast<double>(bias[i % 3]));
  }
  return columns;
}

/// The rays, and where they begin and end.
void SetRays(vtkShaderProgram* program, const vtkTextureSliceParts& uniforms)
{
  const vtkTextureSliceFrame& frame = uniforms.Frame;
  const vtkTextureSlicePlanes& planes = uniforms.Planes;
  const auto& scale = frame.TextureScale;
  const auto& bias = frame.TextureBias;
  auto places = ToTexture(planes.Places, scale, bias);
  auto steps = ToTexture(planes.Steps, scale, {});
  program->SetUniformMatrix3x3("placeOfPixel", places.data());
  program->SetUniformMatrix3x3("stepOfPixel", steps.data());
  const vtkTextureSliceCut& cut = frame.Cut;
  std::array<std::array<float, 3>, 4> faces{};
  std::array<float, 3> toUnits{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const std::array<double, 4> places{
      cut.Part[2 * axis], cut.Part[2 * axis + 1], cut.CropLow[axis], cut.CropHigh[axis]};
    for (std::size_t i = 0; i < places.size(); ++i)
    {
      faces[i][axis] = static_cast<float>(places[i]) * scale[axis] + bias[axis];
    }
    const double edge = std::abs(frame.View.EdgeLength[axis]);
    toUnits[axis] = static_cast<float>(edge / uniforms.Request.GetUnitDistance(0)) / scale[axis];
  }
  program->SetUniform3f("partLow", faces[0].data());
  program->SetUniform3f("partHigh", faces[1].data());
  program->SetUniform3f("cropLow", faces[2].data());
  program->SetUniform3f("cropHigh", faces[3].data());
  program->SetUniformi("cropFlags", cut.CropFlags);
  program->SetUniform3f("stepToUnits", toUnits.data());
  program->SetUniform4f("depthToSlice", planes.DepthToSlice.data());
  program->SetUniformf("pixelSize", static_cast<float>(uniforms.PixelSize));
  std::vector<std::array<float, 4>> clipping;
  for (const std::array<double, 4>& plane : cut.Planes)
  {
    clipping.push_back(frame.ToTexture(plane));
  }
  program->SetUniform4fv("clippingPlanes", static_cast<int>(clipping.size()),
    reinterpret_cast<const float(*)[4]>(clipping.data()));
  if (frame.View.Plane)
  {
    program->SetUniform4f("slicePlane", frame.ToTexture(*frame.View.Plane).data());
  }
}

} // namespace

std::vector<vtkTextureSliceParts::Sampler> vtkTextureSliceParts::FindSamplers()
{
  const vtkTextureSliceFeatures& features = this->Features;
  return {{true, "volumeTexture", this->Texture.GetTexture()},
    {features.Paged, "pageTable", this->Texture.GetPages().GetTable()},
    {true, "transferTable", this->Table.GetTexture()},
    {features.Table2D, "transferTable2D", this->Table2D.GetTexture()},
    {features.Rectilinear, "coordinateTable", this->Coordinates.GetTexture()},
    {features.SecondArray > 0, "secondTexture", this->SecondArray.GetTexture()},
    {features.Blanked, "blankTexture", this->Blanks.GetTexture()},
    {features.HasMask(), "maskTexture", this->Mask.GetTexture()},
    {features.Shadows, "lightTexture", this->Shadows.GetTexture()},
    {features.NeedsDepth(), "geometryDepth", this->Target.GetGeometryDepth()},
    {features.Skipping, "distanceMap", this->EmptySpace.Distances.Texture},
    {features.Slabs, "integralTable", this->Integrals.GetTexture()}};
}

void vtkTextureSliceParts::SetUniforms(vtkShaderProgram* program)
{
  SetRays(program, *this);
  program->SetUniform3f("textureScale", this->Frame.TextureScale.data());
  program->SetUniform3f("textureBias", this->Frame.TextureBias.data());
  program->SetUniform3f("voxelStep", this->Frame.VoxelStep.data());
  program->SetUniform4f("stair", this->Frame.GetStair().data());
  program->SetUniform3f("inverseAspect", this->Frame.InverseAspect.data());
  // What a shader does not have, VTK passes over.
  const vtkTextureSliceFeatures& features = this->Features;
  this->Request.SetUniforms(
    this->Texture.GetComponents(), this->SecondArray.GetComponents(), program);
  this->Table.SetUniforms(program);
  this->EmptySpace.Distances.SetUniforms(program, this->Frame);
  program->SetUniformf("labelWeight", this->Request.Mapper->GetMaskBlendFactor());
  program->SetUniformi("slabsOfPiece", vtkTextureSliceFeatures::SlabsOfPiece);
  this->Integrals.SetUniforms(program);
  if (features.Paged)
  {
    this->Texture.GetPages().SetUniforms(program);
  }
  if (features.Lights >= 0)
  {
    this->Lights.SetUniforms(program, this->Frame);
  }
  if (features.Shadows)
  {
    this->Shadows.SetUniforms(program, *this);
  }
  if (features.Peel > 0)
  {
    this->Peeling.SetUniforms(program);
  }
}

void vtkTextureSliceParts::DrawWith(vtkShaderProgram* program, const std::function<void()>& draw)
{
  std::vector<vtkTextureObject*> active;
  for (const Sampler& sampler : this->FindSamplers())
  {
    if (sampler.Needed)
    {
      sampler.Texture->Activate();
      program->SetUniformi(sampler.Name, sampler.Texture->GetTextureUnit());
      active.push_back(sampler.Texture);
    }
  }
  this->SetUniforms(program);
  draw();
  std::for_each(
    active.rbegin(), active.rend(), [](vtkTextureObject* texture) { texture->Deactivate(); });
}

void vtkTextureSliceParts::Release(vtkOpenGLRenderWindow* window)
{
  if (window == nullptr)
  {
    return;
  }
  window->PushContext();
  for (const Sampler& sampler : this->FindSamplers())
  {
    sampler.Texture->ReleaseGraphicsResources(window);
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

std::string vtkTextureSliceParts::UpdateVolume()
{
  // As in VTK's ray caster, "nearest" holds for the tables as well as for the volume.
  const bool nearest = this->Request.IsNearest();
  const bool cellData = this->Frame.CellData;
  if (this->Coordinates.IsUsed())
  {
    this->Coordinates.Update(this->Window);
  }
  auto source = vtkTextureSliceScalars::Find(this->Image, this->Scalars, cellData);
  source.Places = this->Coordinates.GetPlaces();
  std::string error =
    this->Texture.Update(this->Window, source, nearest, this->Request.CountMostBytes());
  if (!error.empty())
  {
    return error;
  }
  this->Table.Update(this->Window, this->Request.MakeRows(this->Texture.GetComponents()), nearest);
  vtkUnsignedCharArray* flags = vtkTextureSliceScalars::FindGhosts(this->Image, !cellData);
  this->HasBlanks = flags != nullptr && flags->GetRange()[1] > 0.0;
  if (this->HasBlanks)
  {
    error = this->Blanks.Update(
      this->Window, {flags, vtkTextureSliceScalars::GetSize(this->Image, !cellData)}, true);
  }
  if (error.empty() && this->Request.ReadsSecondArray())
  {
    error = this->SecondArray.Update(this->Window,
      vtkTextureSliceScalars::Find(this->Image, this->Request.SecondArray, cellData), nearest);
  }
  return error.empty() && this->Request.GetFeatures().Table2D
           ? this->Table2D.Update(this->Window, this->Request.MakeTables2D(), nearest)
           : error;
}

void vtkTextureSliceParts::UpdateIntegrals()
{
  double unitDistance = 0.0; // the longest
  for (int component = 0; component < this->Request.Components; ++component)
  {
    unitDistance = std::max(unitDistance, this->Request.GetUnitDistance(component));
  }
  const double slab = this->Planes.DataStep;
  const double mostDepth = vtkTextureSliceIntegralTable::ChooseMostDepth(slab / unitDistance);
  this->Integrals.Update(this->Window, this->Table, this->Features.CountFunctions(), mostDepth);
}

std::string vtkTextureSliceParts::Draw()
{
  if (!this->Ways.Choose(*this))
  {
    return "OpenGL could not compile the shaders of the slices";
  }
  std::string error = this->Target.Begin(*this);
  if (error.empty())
  {
    if (this->Features.Slabs)
    {
      this->UpdateIntegrals();
    }
    if (this->Features.Shadows)
    {
      this->Shadows.Upload(this->Window, this->Features.HasJoinedLight());
    }
    if (this->Features.Skipping)
    {
      this->EmptySpace.Distances.Upload(this->Window);
    }
    this->Ways.Draw(*this);
    this->Target.End();
  }
  return error;
}
