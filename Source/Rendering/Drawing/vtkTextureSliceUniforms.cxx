// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSliceUniforms.h"

#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"
#include "vtkTextureSliceBlanks.h"
#include "vtkTextureSliceCoordinates.h"
#include "vtkTextureSliceDistanceMap.h"
#include "vtkTextureSliceFrame.h"
#include "vtkTextureSliceIntegralTable.h"
#include "vtkTextureSliceLights.h"
#include "vtkTextureSlicePeeling.h"
#include "vtkTextureSlicePlanes.h"
#include "vtkTextureSliceShadows.h"
#include "vtkTextureSliceTable.h"
#include "vtkTextureSliceTable2D.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>

namespace
{

std::vector<float> Gather(const std::vector<vtkTextureSliceSurface>& surfaces,
  const std::function<float(const vtkTextureSliceSurface&)>& get)
{
  std::vector<float> values;
  std::transform(surfaces.begin(), surfaces.end(), std::back_inserter(values), get);
  return values;
}

void SetArray(vtkShaderProgram* program, const char* name, const std::vector<float>& values)
{
  program->SetUniform1fv(name, static_cast<int>(values.size()), values.data());
}

void SetTable(vtkShaderProgram* program, const vtkTextureSliceUniforms& uniforms)
{
  program->SetUniformi("transferTable", uniforms.Table->GetTexture()->GetTextureUnit());
  program->SetUniformf("tableScale", static_cast<float>(uniforms.Table->GetScale()));
  program->SetUniformf("tableBias", static_cast<float>(uniforms.Table->GetBias()));
  SetArray(program, "componentWeight",
    Gather(uniforms.Surfaces, [](const auto& surface) { return surface.Weight; }));
  const float inverseUnitDistance = uniforms.Surfaces.front().InverseUnitDistance;
  SetArray(program, "unitDistanceRatio",
    Gather(uniforms.Surfaces, [inverseUnitDistance](const auto& surface)
      { return surface.InverseUnitDistance / inverseUnitDistance; }));
}

void SetVolume(vtkShaderProgram* program, const vtkTextureSliceUniforms& uniforms)
{
  const vtkTextureSliceFrame& frame = *uniforms.Frame;
  program->SetUniform3f("textureScale", frame.GetTextureScale().data());
  program->SetUniform3f("textureBias", frame.GetTextureBias().data());
  program->SetUniformi("volumeTexture", uniforms.Volume->GetTextureUnit());
  program->SetUniform4f("scalarScale", uniforms.ScalarScale.data());
  program->SetUniform4f("scalarBias", uniforms.ScalarBias.data());
  program->SetUniform3f("cropLow", frame.GetCropLow().data());
  program->SetUniform3f("cropHigh", frame.GetCropHigh().data());
  program->SetUniformi("cropFlags", uniforms.CropFlags);
  program->SetUniform3f("voxelStep", frame.GetVoxelStep().data());
  program->SetUniform4f("stair", frame.GetStair().data());
  program->SetUniform3f("inverseAspect", frame.GetInverseAspect().data());
  program->SetUniform2f("averageRange", uniforms.AverageRange.data());
  program->SetUniform4f("clippedScalars", uniforms.ClippedScalars.data());
  if (uniforms.Features.IsoValues > 0)
  {
    SetArray(program, "isoValues", uniforms.IsoValues);
  }
}

void SetMaskAndTables(vtkShaderProgram* program, const vtkTextureSliceUniforms& uniforms)
{
  const vtkTextureSliceFeatures& features = uniforms.Features;
  if (features.Table2D)
  {
    program->SetUniformi("transferTable2D", uniforms.Table2D->GetTexture()->GetTextureUnit());
    program->SetUniformf("table2DRows", static_cast<float>(uniforms.Table2D->GetNumberOfRows()));
  }
  if (features.Rectilinear)
  {
    program->SetUniformi("coordinateTable", uniforms.Coordinates->GetTexture()->GetTextureUnit());
    const auto entry = static_cast<float>(uniforms.Coordinates->GetMargin());
    const std::array<float, 2> scaleAndBias{1.0f - entry, 0.5f * entry};
    program->SetUniform2f("coordinateScaleAndBias", scaleAndBias.data());
    program->SetUniform3f("placeScale", uniforms.Frame->GetTextureScale().data());
    program->SetUniform3f("placeBias", uniforms.Frame->GetTextureBias().data());
  }
  if (features.SecondArray > 0)
  {
    program->SetUniformi("secondTexture", uniforms.SecondArray->GetTextureUnit());
    program->SetUniform4f("secondScale", uniforms.SecondScale.data());
    program->SetUniform4f("secondBias", uniforms.SecondBias.data());
  }
  if (features.Blanked)
  {
    uniforms.Blanks->SetUniforms(program);
  }
  if (features.HasMask())
  {
    program->SetUniformi("maskTexture", uniforms.Mask->GetTextureUnit());
  }
  if (features.Labels > 0)
  {
    vtkTextureSliceTable& table = *uniforms.LabelTable;
    program->SetUniformi("labelTable", table.GetTexture()->GetTextureUnit());
    program->SetUniformf("labelTableScale", static_cast<float>(table.GetScale()));
    program->SetUniformf("labelTableBias", static_cast<float>(table.GetBias()));
    program->SetUniformf("labelWeight", uniforms.LabelWeight);
  }
}

void SetLight(vtkShaderProgram* program, const vtkTextureSliceUniforms& uniforms)
{
  std::vector<float> material;
  for (const vtkTextureSliceSurface& surface : uniforms.Surfaces)
  {
    material.insert(material.end(), surface.Material.begin(), surface.Material.end());
  }
  program->SetUniform4fv("material", static_cast<int>(uniforms.Surfaces.size()), material.data());
  uniforms.Lights->SetUniforms(program, *uniforms.Frame);
}

/// Columns of a matrix that takes a pixel to a place, or with a bias of 0 a way, in the texture.
std::array<float, 9> ToTexture(const vtkTextureSlicePixelMap& map,
  const std::array<float, 3>& scale, const std::array<float, 3>& bias)
{
  std::array<float, 9> columns{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const auto perBox = static_cast<double>(scale[axis]);
    columns[axis] = static_cast<float>(map.Right[axis] * perBox);
    columns[3 + axis] = static_cast<float>(map.Up[axis] * perBox);
    columns[6 + axis] =
      static_cast<float>(map.Origin[axis] * perBox + static_cast<double>(bias[axis]));
  }
  return columns;
}

/// The rays, and where they begin and end.
void SetRays(vtkShaderProgram* program, const vtkTextureSliceUniforms& uniforms)
{
  const vtkTextureSliceFrame& frame = *uniforms.Frame;
  const vtkTextureSlicePlanes& planes = *uniforms.Planes;
  const auto& scale = frame.GetTextureScale();
  const auto& bias = frame.GetTextureBias();
  auto places = ToTexture(planes.GetPlaces(), scale, bias);
  auto steps = ToTexture(planes.GetSteps(), scale, {});
  program->SetUniformMatrix3x3("placeOfPixel", places.data());
  program->SetUniformMatrix3x3("stepOfPixel", steps.data());
  const auto& part = frame.GetView().Part;
  std::array<float, 3> low{};
  std::array<float, 3> high{};
  std::array<float, 3> toUnits{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    low[axis] = static_cast<float>(part[2 * axis]) * scale[axis] + bias[axis];
    high[axis] = static_cast<float>(part[2 * axis + 1]) * scale[axis] + bias[axis];
    toUnits[axis] = std::abs(frame.GetEdges()[axis]) / scale[axis] *
                    uniforms.Surfaces.front().InverseUnitDistance;
  }
  program->SetUniform3f("partLow", low.data());
  program->SetUniform3f("partHigh", high.data());
  program->SetUniform3f("stepToUnits", toUnits.data());
  program->SetUniform4f("depthToSlice", planes.GetDepthToSlice().data());
  program->SetUniformf("pixelSize", static_cast<float>(uniforms.PixelSize));
  const std::vector<float> clipping = frame.GetClippingPlanesInTexture();
  if (!clipping.empty())
  {
    program->SetUniform4fv(
      "clippingPlanes", static_cast<int>(clipping.size() / 4), clipping.data());
  }
  if (frame.GetView().Plane)
  {
    program->SetUniform4f("slicePlane", frame.ToTexture(*frame.GetView().Plane).data());
  }
}

/// The number of the last entry of a row.
float GetLastEntry(const vtkTextureSliceIntegralTable& integrals)
{
  return static_cast<float>(integrals.GetWidth() - 1);
}

void SetSlabs(vtkShaderProgram* program, const vtkTextureSliceUniforms& uniforms)
{
  program->SetUniformi("integralTable", uniforms.Integrals->GetTexture()->GetTextureUnit());
  program->SetUniformf("lastIntegral", GetLastEntry(*uniforms.Integrals));
  program->SetUniformi("slabsOfPiece", vtkTextureSliceFeatures::SlabsOfPiece);
  if (uniforms.Features.Labels > 0)
  {
    program->SetUniformi(
      "labelIntegralTable", uniforms.LabelIntegrals->GetTexture()->GetTextureUnit());
    program->SetUniformf("lastLabelIntegral", GetLastEntry(*uniforms.LabelIntegrals));
  }
}

} // namespace

std::vector<vtkTextureObject*> vtkTextureSliceUniforms::GetTextures() const
{
  std::vector<vtkTextureObject*> textures{this->Volume, this->Table->GetTexture()};
  if (this->Features.Table2D)
  {
    textures.push_back(this->Table2D->GetTexture());
  }
  if (this->Features.Rectilinear)
  {
    textures.push_back(this->Coordinates->GetTexture());
  }
  if (this->Features.SecondArray > 0)
  {
    textures.push_back(this->SecondArray);
  }
  if (this->Features.Blanked)
  {
    textures.push_back(this->Blanks->GetTexture());
  }
  if (this->Features.HasMask())
  {
    textures.push_back(this->Mask);
  }
  if (this->Features.Labels > 0)
  {
    textures.push_back(this->LabelTable->GetTexture());
  }
  if (this->Features.Shadows)
  {
    textures.push_back(this->Shadows->GetTexture());
  }
  if (this->Features.NeedsDepth())
  {
    textures.push_back(this->GeometryDepth);
  }
  if (this->Features.Skipping)
  {
    textures.push_back(this->Distances->GetTexture());
  }
  if (this->Features.Slabs)
  {
    textures.push_back(this->Integrals->GetTexture());
    if (this->Features.Labels > 0)
    {
      textures.push_back(this->LabelIntegrals->GetTexture());
    }
  }
  return textures;
}

void vtkTextureSliceUniforms::Use(
  vtkShaderProgram* program, const std::function<void()>& draw) const
{
  const std::vector<vtkTextureObject*> textures = this->GetTextures();
  std::for_each(textures.begin(), textures.end(), [](vtkTextureObject* t) { t->Activate(); });
  this->Set(program);
  draw();
  std::for_each(textures.rbegin(), textures.rend(), [](vtkTextureObject* t) { t->Deactivate(); });
}

void vtkTextureSliceUniforms::Set(vtkShaderProgram* program) const
{
  SetRays(program, *this);
  SetVolume(program, *this);
  SetTable(program, *this);
  SetMaskAndTables(program, *this);
  if (this->Features.Lights >= 0)
  {
    SetLight(program, *this);
  }
  if (this->Features.Shadows)
  {
    this->Shadows->SetUniforms(program, *this);
  }
  if (this->Features.Skipping)
  {
    this->Distances->SetUniforms(program, *this->Frame);
  }
  if (this->Features.NeedsDepth())
  {
    program->SetUniformi("geometryDepth", this->GeometryDepth->GetTextureUnit());
  }
  if (this->Features.Peel > 0)
  {
    this->Peeling->SetUniforms(program);
  }
  if (this->Features.Slabs)
  {
    SetSlabs(program, *this);
  }
}
