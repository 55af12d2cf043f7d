// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSliceShadows.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkMatrix3x3.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLTextureSliceVolumeMapper.h"
#include "vtkPointData.h"
#include "vtkShaderProgram.h"
#include "vtkTextureSliceOpenGL.h"
#include "vtkTextureSliceParts.h"
#include "vtkVolumeMapper.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace
{

using Function = vtkTextureSliceLightCells::Function;
using Lights = vtkTextureSliceLightVolume::Lights;
using Source = vtkTextureSliceParts;

/// As many cells as a volume of 256 x 256 x 128 voxels has at half its resolution.
constexpr std::size_t MostCells = 1048576;
constexpr std::size_t MostCellsOfInteraction = MostCells / 8;

/// What a surface of opacity 1 takes: no 16-bit texel shows what is left.
constexpr double MostDepthOfASurface = 16.0;

/// Shadows lie in places, and scalars alone decide how dense these are.
bool CanShow(const vtkTextureSliceFeatures& features)
{
  return features.IsoValues > 0 ||
         (features.BlendMode == vtkVolumeMapper::COMPOSITE_BLEND && !features.Table2D);
}

bool IsDirection(const std::array<double, 3>& vector)
{
  const double length = std::hypot(vector[0], vector[1], vector[2]);
  return length > 0.0 && std::isfinite(length);
}

Lights FindLights(const Source& source)
{
  vtkOpenGLTextureSliceVolumeMapper* mapper = source.Request.Mapper;
  const auto direction = [](const double* v) { return std::array<double, 3>{v[0], v[1], v[2]}; };
  const auto toLight = direction(mapper->GetLightDirection());
  auto zenith = direction(mapper->GetZenith());
  Lights lights;
  lights.Shadow = mapper->GetShadowStrength() > 0.0 && IsDirection(toLight);
  lights.Occlusion = mapper->GetOcclusionStrength() > 0.0 && IsDirection(zenith);
  lights.ToLight = {};
  if (lights.Shadow)
  {
    lights.ToLight = source.Frame.GetDataDirection(toLight);
  }
  if (lights.Occlusion)
  {
    double east[3];
    double north[3];
    vtkMath::Normalize(zenith.data());
    vtkMath::Perpendiculars(zenith.data(), east, north, 0.0);
    lights.Sky = {source.Frame.GetDataDirection(direction(east)),
      source.Frame.GetDataDirection(direction(north)), source.Frame.GetDataDirection(zenith)};
  }
  return lights;
}

/// The functions of each value of the mask, if there is one; a label's own count as much as its
/// weight says.
std::vector<std::vector<Function>> MakeFunctions(const Source& source, double density)
{
  const vtkTextureSliceFeatures features = source.Request.GetFeatures();
  const auto& components = source.Texture.GetComponents();
  // The table has halvings of a unit distance.
  const auto make = [&](std::size_t row, std::size_t component, double weight)
  {
    Function function{component, components[component].Range, source.Table.GetOpacities(row)};
    const int number = static_cast<int>(component);
    const auto scale =
      static_cast<float>(density * std::log(2.0) * weight * source.Request.GetWeight(number) /
                         source.Request.GetUnitDistance(number));
    for (float& entry : function.Entries)
    {
      entry *= scale;
    }
    return function;
  };
  const auto count = static_cast<std::size_t>(features.Functions);
  std::vector<std::vector<Function>> functions(features.BinaryMask ? 2 : 1);
  for (std::size_t i = 0; i < count; ++i)
  {
    // One function for each component, or that of the opacity.
    functions.back().push_back(make(i, count > 1 ? i : components.size() - 1, 1.0));
  }
  const auto weight = static_cast<double>(source.Request.Mapper->GetMaskBlendFactor());
  for (int label = 1; label <= features.Labels; ++label)
  {
    functions.push_back(
      {make(static_cast<std::size_t>(label), 0, weight), make(0, 0, 1.0 - weight)});
  }
  return functions;
}

/// The isosurfaces as light crosses them; none in other blend modes.
std::vector<vtkTextureSliceLightCells::Surface> MakeSurfaces(const Source& source, double density)
{
  std::vector<vtkTextureSliceLightCells::Surface> surfaces;
  const std::vector<float> opacities = source.Table.GetOpacities(0);
  const auto last = static_cast<double>(opacities.size() - 1);
  const std::array<double, 2>& range = source.Texture.GetComponents().back().Range;
  const double width = range[1] > range[0] ? range[1] - range[0] : 1.0;
  for (const double value : source.Request.GetIsoValues())
  {
    const double entry = std::clamp((value - range[0]) / width, 0.0, 1.0) * last;
    const auto opacity = static_cast<double>(opacities[static_cast<std::size_t>(entry + 0.5)]);
    const double depth = opacity < 1.0 ? -std::log(1.0 - opacity) : MostDepthOfASurface / density;
    surfaces.push_back({static_cast<float>(value),
      density > 0.0 ? static_cast<float>(std::min(depth * density, MostDepthOfASurface)) : 0.0f});
  }
  return surfaces;
}

vtkTextureSliceLightCells::Source MakeCells(const Source& source, double density)
{
  const vtkTextureSliceFeatures features = source.Request.GetFeatures();
  vtkTextureSliceLightCells::Source made;
  made.Scalars = vtkTextureSliceScalars::Find(source.Image, source.Scalars, source.Frame.CellData);
  made.Masked = source.Texture.IsMasked();
  if (features.HasMask())
  {
    made.Mask = static_cast<const unsigned char*>(source.MaskValues->GetVoidPointer(0));
  }
  if (features.IsoValues > 0)
  {
    made.Surfaces = MakeSurfaces(source, density);
    made.Component = source.Texture.GetComponents().size() - 1;
  }
  else
  {
    made.Functions = MakeFunctions(source, density);
  }
  const double* spacing = source.Image->GetSpacing();
  made.VoxelEdge = {std::abs(spacing[0]), std::abs(spacing[1]), std::abs(spacing[2])};
  if (!(source.Frame.Cut == vtkTextureSliceCut()))
  {
    made.Left = source.Frame.Cut;
  }
  return made;
}

} // namespace

void vtkTextureSliceShadows::Update(Source& source, bool interactive)
{
  const vtkTextureSliceFeatures features = source.Request.GetFeatures();
  vtkOpenGLTextureSliceVolumeMapper* mapper = source.Request.Mapper;
  // The light is computed in cells of one size.
  this->Used = (mapper->GetShadowStrength() > 0.0 || mapper->GetOcclusionStrength() > 0.0) &&
               CanShow(features) && !source.Coordinates.IsUsed();
  if (!this->Used)
  {
    return;
  }
  Key key{
    {source.Texture.GetBricks().BuildTime, features.HasMask() ? source.MaskValues->GetMTime() : 0},
    MakeCells(source, mapper->GetShadowDensity()), FindLights(source)};
  // The shader weakens by surfaces themselves, too: not without a light, or a sky.
  this->Strength = {key.From.Shadow ? static_cast<float>(mapper->GetShadowStrength()) : 0.0f,
    key.From.Occlusion ? static_cast<float>(mapper->GetOcclusionStrength()) : 0.0f};
  const bool otherCells = key.Times != this->Last.Times || !key.Cells.IsLike(this->Last.Cells);
  const bool finer = this->Coarse && !interactive;
  if (otherCells || finer || !(key.From == this->Last.From))
  {
    if (otherCells || this->Coarse != interactive)
    {
      this->Cells.emplace(key.Cells, interactive ? MostCellsOfInteraction : MostCells);
      this->Coarse = interactive;
    }
    this->Volume.Build(*this->Cells, key.From,
      [&source](const auto& cells, const auto& courses, std::vector<float>& sums)
      { return source.Ways.SweepLight(source, cells, courses, sums); });
    this->Last = std::move(key);
    this->MakeImage(source.Image, source.Frame.CellData);
    this->Texture->ReleaseGraphicsResources(source.Window);
  }
  this->Exposure = static_cast<float>(mapper->GetExposure());
}

void vtkTextureSliceShadows::Upload(vtkOpenGLRenderWindow* window, bool joined)
{
  const std::tuple<bool, float, std::array<float, 2>> wanted{
    joined, this->Exposure, this->Strength};
  if (this->Texture->GetHandle() != 0 && wanted == this->Uploaded)
  {
    return;
  }
  this->Uploaded = wanted;
  float* light = this->Volume.GetLight()->GetPointer(0);
  std::vector<float> product(joined ? this->Volume.GetGrid().CountCells() : 0);
  for (std::size_t i = 0; i < product.size(); ++i)
  {
    product[i] = this->Exposure * (1.0f - this->Strength[0] * (1.0f - light[2 * i])) *
                 (1.0f - this->Strength[1] * (1.0f - light[2 * i + 1]));
  }
  const auto& size = this->Volume.GetGrid().Size;
  this->Texture->SetContext(window);
  this->Texture->ResetFormatAndType();
  vtkTextureSliceSetSampling(this->Texture, false);
  this->Texture->Create3DFromRaw(static_cast<unsigned int>(size[0]),
    static_cast<unsigned int>(size[1]), static_cast<unsigned int>(size[2]), joined ? 1 : 2,
    VTK_FLOAT, joined ? product.data() : light);
}

void vtkTextureSliceShadows::MakeImage(vtkImageData* volume, bool cellData)
{
  const vtkTextureSliceLightGrid& grid = this->Volume.GetGrid();
  double first[3];
  double origin[3];
  double spacing[3];
  int extent[6];
  volume->GetExtent(extent);
  volume->GetSpacing(spacing);
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    first[axis] = extent[2 * axis] + (grid.Factor[axis] - 1) / 2.0 + (cellData ? 0.5 : 0.0);
    spacing[axis] *= grid.Factor[axis];
  }
  volume->TransformContinuousIndexToPhysicalPoint(first, origin);
  this->Image->Initialize();
  this->Image->SetDimensions(grid.Size.data());
  this->Image->SetOrigin(origin);
  this->Image->SetSpacing(spacing);
  this->Image->SetDirectionMatrix(volume->GetDirectionMatrix());
  this->Image->GetPointData()->SetScalars(this->Volume.GetLight());
}

void vtkTextureSliceShadows::SetUniforms(
  vtkShaderProgram* program, const vtkTextureSliceParts& uniforms) const
{
  program->SetUniform3f("lightTextureScale", this->Volume.GetGrid().GetTextureScale().data());
  program->SetUniform2f("lightStrength", this->Strength.data());
  if (!this->Last.Cells.Surfaces.empty())
  {
    this->SetSurfaces(program, uniforms);
  }
}

void vtkTextureSliceShadows::SetSurfaces(
  vtkShaderProgram* program, const vtkTextureSliceParts& uniforms) const
{
  const vtkTextureSliceLightGrid& grid = this->Volume.GetGrid();
  std::array<double, 3> toLight = this->Last.From.ToLight;
  std::array<float, 3> gradientToCells{};
  std::array<float, 3> gradientToChange{};
  std::array<float, 3> cell{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    // The gradient is the change over two voxels, times the signed aspect of the shader.
    const float aspect = uniforms.Frame.InverseAspect[axis];
    const float sign = aspect < 0.0f ? -1.0f : 1.0f;
    toLight[axis] /= grid.CellEdge[axis];
    gradientToCells[axis] = sign * static_cast<float>(grid.CellEdge[axis]);
    gradientToChange[axis] = 0.5f * static_cast<float>(grid.Factor[axis]) / aspect;
    cell[axis] = 1.0f / static_cast<float>(grid.Size[axis]);
  }
  vtkMath::Normalize(toLight.data());
  std::vector<float> surfaces; // value and what it takes of the light
  const std::vector<float> values =
    uniforms.Request.FindIsoValues(uniforms.Texture.GetComponents());
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    surfaces.push_back(values[i]);
    surfaces.push_back(1.0f - std::exp(-this->Last.Cells.Surfaces[i].second));
  }
  program->SetUniform3f("toLight", toLight.data());
  program->SetUniform3f("gradientToCells", gradientToCells.data());
  program->SetUniform3f("gradientToChange", gradientToChange.data());
  program->SetUniform3f("lightCell", cell.data());
  program->SetUniform2fv("lightSurfaces", static_cast<int>(surfaces.size() / 2),
    reinterpret_cast<const float(*)[2]>(surfaces.data()));
}
