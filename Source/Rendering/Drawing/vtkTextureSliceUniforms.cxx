// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSliceUniforms.h"

#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"
#include "vtkTextureSliceFrame.h"
#include "vtkTextureSlicePlanes.h"

#include <algorithm>
#include <cmath>

namespace
{

void SetSurfaces(vtkShaderProgram* program, const std::vector<vtkTextureSliceSurface>& surfaces)
{
  std::vector<float> weights;
  std::vector<float> ratios;
  std::vector<float> material;
  for (const vtkTextureSliceSurface& surface : surfaces)
  {
    weights.push_back(surface.Weight);
    ratios.push_back(surface.InverseUnitDistance / surfaces.front().InverseUnitDistance);
    material.insert(material.end(), surface.Material.begin(), surface.Material.end());
  }
  const int count = static_cast<int>(surfaces.size());
  program->SetUniform1fv("componentWeight", count, weights.data());
  program->SetUniform1fv("unitDistanceRatio", count, ratios.data());
  program->SetUniform4fv("material", count, material.data());
}

void SetFrame(vtkShaderProgram* program, const vtkTextureSliceFrame& frame)
{
  program->SetUniform3f("textureScale", frame.GetTextureScale().data());
  program->SetUniform3f("textureBias", frame.GetTextureBias().data());
  program->SetUniform3f("placeScale", frame.GetTextureScale().data());
  program->SetUniform3f("placeBias", frame.GetTextureBias().data());
  program->SetUniform3f("cropLow", frame.GetCropLow().data());
  program->SetUniform3f("cropHigh", frame.GetCropHigh().data());
  program->SetUniform3f("voxelStep", frame.GetVoxelStep().data());
  program->SetUniform4f("stair", frame.GetStair().data());
  program->SetUniform3f("inverseAspect", frame.GetInverseAspect().data());
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

} // namespace

void vtkTextureSliceUniforms::Use(
  vtkShaderProgram* program, const std::function<void()>& draw) const
{
  for (const auto& [sampler, texture] : this->Textures)
  {
    texture->Activate();
    program->SetUniformi(sampler, texture->GetTextureUnit());
  }
  SetRays(program, *this);
  SetFrame(program, *this->Frame);
  SetSurfaces(program, this->Surfaces);
  this->SetParts(program);
  draw();
  std::for_each(this->Textures.rbegin(), this->Textures.rend(),
    [](const auto& named) { named.second->Deactivate(); });
}
