// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSliceShadows.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkMatrix3x3.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPointData.h"
#include "vtkShaderProgram.h"
#include "vtkTextureSliceFrame.h"
#include "vtkTextureSliceOpenGL.h"
#include "vtkTextureSliceRequest.h"
#include "vtkTextureSliceTable.h"
#include "vtkTextureSliceTexture.h"
#include "vtkUnsignedShortArray.h"
#include "vtkVolumeMapper.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace
{

using Function = vtkTextureSliceExtinction::Function;
using Lights = vtkTextureSliceLightVolume::Lights;
using Source = vtkTextureSliceShadows::Source;

/// As many cells as a volume of 256 x 256 x 128 voxels has at half its resolution.
constexpr std::size_t MostCells = 1048576;
constexpr std::size_t MostCellsOfInteraction = MostCells / 8;

/// What a surface of opacity 1 takes: no 16-bit texel shows what is left.
constexpr double MostDepthOfASurface = 16.0;

bool HasSurfaces(const vtkTextureSliceFeatures& features)
{
  return features.IsoValues > 0;
}

/// Shadows lie in places, and scalars alone decide how dense these are.
bool CanShow(const vtkTextureSliceFeatures& features)
{
  return HasSurfaces(features) ||
         (features.BlendMode == vtkVolumeMapper::COMPOSITE_BLEND && !features.Table2D);
}

bool IsDirection(const std::array<double, 3>& vector)
{
  const double length = std::hypot(vector[0], vector[1], vector[2]);
  return length > 0.0 && std::isfinite(length);
}

Lights FindLights(const Source& source, const vtkTextureSliceShadowSettings& settings)
{
  Lights lights;
  lights.Shadow =
    (settings.Shadow > 0.0 || settings.Scattering > 0.0) && IsDirection(settings.ToLight);
  lights.Occlusion = settings.Occlusion > 0.0 && IsDirection(settings.Zenith);
  lights.Reach = settings.Reach;
  lights.ToLight = source.Frame->GetDataDirection(settings.ToLight);
  double east[3];
  double north[3];
  std::array<double, 3> zenith = settings.Zenith;
  vtkMath::Normalize(zenith.data());
  vtkMath::Perpendiculars(zenith.data(), east, north, 0.0);
  lights.Sky = {source.Frame->GetDataDirection({east[0], east[1], east[2]}),
    source.Frame->GetDataDirection({north[0], north[1], north[2]}),
    source.Frame->GetDataDirection(zenith)};
  return lights;
}

/// What turns a row's optical depths, in halvings of a unit distance, into extinctions.
std::vector<float> FindScales(const vtkTextureSliceRequest& request, double density)
{
  std::vector<float> scales;
  for (const vtkTextureSliceSurface& surface : request.MakeSurfaces())
  {
    scales.push_back(
      static_cast<float>(density * std::log(2.0)) * surface.InverseUnitDistance * surface.Weight);
  }
  return scales;
}

Function MakeFunction(const vtkTextureSliceTable& table, std::size_t row,
  const vtkTextureSliceComponent& component, std::size_t index, float scale)
{
  Function function{index, component.Range, table.GetAlphas(row)};
  for (float& entry : function.Entries)
  {
    entry *= scale;
  }
  return function;
}

/// One function for each component that has its own, or that of the opacity.
std::vector<Function> MakeFunctions(const Source& source, double density)
{
  const auto& components = source.Texture->GetComponents();
  const std::vector<float> scales = FindScales(*source.Request, density);
  const auto count = static_cast<std::size_t>(source.Request->GetFeatures().Functions);
  std::vector<Function> functions;
  for (std::size_t i = 0; i < count; ++i)
  {
    const std::size_t component = count > 1 ? i : components.size() - 1;
    functions.push_back(
      MakeFunction(*source.Table, i, components[component], component, scales[i]));
  }
  return functions;
}

/// The functions of each label; a label's own count as much as its weight says.
std::vector<std::vector<Function>> MakeLabelFunctions(
  const Source& source, int labels, double density)
{
  const Function common = MakeFunctions(source, density).front();
  const auto& component = source.Texture->GetComponents().front();
  const float scale = FindScales(*source.Request, density).front();
  std::vector<std::vector<Function>> functions{{common}};
  for (int label = 0; label < labels; ++label)
  {
    const auto row = static_cast<std::size_t>(label);
    const auto weight = static_cast<float>(source.LabelWeight);
    functions.push_back(
      {MakeFunction(*source.LabelTable, row, component, 0, scale * weight), common});
    for (float& entry : functions.back()[1].Entries)
    {
      entry *= 1.0f - weight;
    }
  }
  return functions;
}

/// Whether a place of the box is outside of what cropping and clipping planes leave.
std::function<bool(const std::array<double, 3>&)> MakeCut(const Source& source)
{
  const vtkTextureSliceFrame& frame = *source.Frame;
  const vtkTextureSliceView& view = frame.GetView();
  const bool whole = view.Part == std::array<double, 6>{0, 1, 0, 1, 0, 1};
  if (whole && view.ClippingPlanes.empty() && !frame.NeedsCropTest())
  {
    return {};
  }
  return [&frame, &view, flags = source.CropFlags](const std::array<double, 3>& at)
  {
    int region = 0;
    constexpr std::array<int, 3> weights{1, 3, 9};
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      if (at[axis] < view.Part[2 * axis] || at[axis] > view.Part[2 * axis + 1])
      {
        return true;
      }
      const double texture = at[axis] * static_cast<double>(frame.GetTextureScale()[axis]) +
                             static_cast<double>(frame.GetTextureBias()[axis]);
      region +=
        weights[axis] * ((texture >= static_cast<double>(frame.GetCropLow()[axis]) ? 1 : 0) +
                          (texture > static_cast<double>(frame.GetCropHigh()[axis]) ? 1 : 0));
    }
    const bool clipped = std::any_of(view.ClippingPlanes.begin(), view.ClippingPlanes.end(),
      [&](const std::array<double, 4>& plane)
      { return plane[0] * at[0] + plane[1] * at[1] + plane[2] * at[2] + plane[3] < 0.0; });
    return clipped || (frame.NeedsCropTest() && (flags >> region & 1) == 0);
  };
}

/// A value of the component that has the surfaces as the shader knows it, 0 to 1 over the range.
double Normalize(const Source& source, double value)
{
  const std::array<double, 2>& range = source.Texture->GetComponents().back().Range;
  return (value - range[0]) / (range[1] > range[0] ? range[1] - range[0] : 1.0);
}

/// The opacity of a surface as the shader looks it up in the first row of the table.
double FindOpacity(const Source& source, double value)
{
  const auto last = static_cast<double>(source.Table->GetWidth() - 1);
  const double entry = std::clamp(Normalize(source, value), 0.0, 1.0) * last;
  const auto low = static_cast<std::size_t>(entry);
  const std::size_t high = std::min(low + 1, source.Table->GetWidth() - 1);
  const double part = entry - static_cast<double>(low);
  const float* entries = source.Table->GetEntries(0);
  return (1.0 - part) * static_cast<double>(entries[4 * low + 3]) +
         part * static_cast<double>(entries[4 * high + 3]);
}

/// The isosurfaces as light crosses them; none in other blend modes.
std::vector<vtkTextureSliceSurfaceScalars::Surface> MakeSurfaces(
  const Source& source, double density)
{
  std::vector<vtkTextureSliceSurfaceScalars::Surface> surfaces;
  for (const double value : source.Request->GetIsoValues())
  {
    const double opacity = FindOpacity(source, value);
    const double depth = opacity < 1.0 ? -std::log(1.0 - opacity) : MostDepthOfASurface / density;
    surfaces.push_back({static_cast<float>(value),
      density > 0.0 ? static_cast<float>(std::min(depth * density, MostDepthOfASurface)) : 0.0f});
  }
  return surfaces;
}

vtkTextureSliceSurfaceScalars::Source MakeSurfaceSource(const Source& source, double density)
{
  vtkTextureSliceSurfaceScalars::Source made;
  made.Scalars =
    vtkTextureSliceScalars::Find(source.Image, source.Scalars, source.Frame->IsOfCells());
  made.Component = source.Texture->GetComponents().size() - 1;
  made.Masked = source.Texture->IsMasked();
  if (source.Request->GetFeatures().HasMask())
  {
    made.Mask = static_cast<const unsigned char*>(source.MaskValues->GetVoidPointer(0));
  }
  const double* spacing = source.Image->GetSpacing();
  made.VoxelEdge = {std::abs(spacing[0]), std::abs(spacing[1]), std::abs(spacing[2])};
  made.IsCut = MakeCut(source);
  made.Surfaces = MakeSurfaces(source, density);
  return made;
}

vtkTextureSliceExtinction::Source MakeSource(const Source& source, double density)
{
  const vtkTextureSliceFeatures features = source.Request->GetFeatures();
  vtkTextureSliceExtinction::Source made;
  made.Scalars =
    vtkTextureSliceScalars::Find(source.Image, source.Scalars, source.Frame->IsOfCells());
  made.Masked = source.Texture->IsMasked();
  if (features.Labels > 0)
  {
    made.Functions = MakeLabelFunctions(source, features.Labels, density);
  }
  else if (features.BinaryMask)
  {
    made.Functions = {{}, MakeFunctions(source, density)};
  }
  else
  {
    made.Functions = {MakeFunctions(source, density)};
  }
  if (features.HasMask())
  {
    made.Mask = static_cast<const unsigned char*>(source.MaskValues->GetVoidPointer(0));
  }
  const double* spacing = source.Image->GetSpacing();
  made.VoxelEdge = {std::abs(spacing[0]), std::abs(spacing[1]), std::abs(spacing[2])};
  made.IsCut = MakeCut(source);
  return made;
}

} // namespace

vtkTextureSliceShadows::vtkTextureSliceShadows() = default;
vtkTextureSliceShadows::~vtkTextureSliceShadows() = default;

vtkTextureSliceShadows::Key vtkTextureSliceShadows::MakeKey(
  const Source& source, const Lights& lights, double density)
{
  const vtkTextureSliceFeatures features = source.Request->GetFeatures();
  const vtkTextureSliceFrame& frame = *source.Frame;
  std::vector<double> numbers(frame.GetView().Part.begin(), frame.GetView().Part.end());
  const double* spacing = source.Image->GetSpacing();
  numbers.insert(numbers.end(), spacing, spacing + 3);
  numbers.push_back(source.LabelWeight);
  const auto add = [&numbers](const auto& values)
  { numbers.insert(numbers.end(), values.begin(), values.end()); };
  if (lights.Shadow)
  {
    add(lights.ToLight);
    numbers.push_back(lights.Reach);
  }
  for (std::size_t i = 0; i < 3 && lights.Occlusion; ++i)
  {
    add(lights.Sky[i]);
  }
  if (frame.NeedsCropTest())
  {
    add(frame.GetCropLow());
    add(frame.GetCropHigh());
  }
  const std::array<vtkMTimeType, 4> times{source.Texture->GetBricks().GetBuildTime(),
    source.Table->GetFillTime(), features.Labels > 0 ? source.LabelTable->GetFillTime() : 0,
    features.HasMask() ? source.MaskValues->GetMTime() : 0};
  for (const auto& [value, depth] : MakeSurfaces(source, density))
  {
    add(std::array<float, 2>{value, depth});
  }
  const int parts = (lights.Shadow ? 1 : 0) + (lights.Occlusion ? 2 : 0);
  const int cropped = frame.NeedsCropTest() ? source.CropFlags : -1;
  return {times, features.GetDefines() + std::to_string(parts),
    FindScales(*source.Request, density), numbers, frame.GetView().ClippingPlanes, cropped};
}

void vtkTextureSliceShadows::Update(
  vtkOpenGLRenderWindow* window, const Source& source, const vtkTextureSliceShadowSettings& asked)
{
  const vtkTextureSliceFeatures features = source.Request->GetFeatures();
  const bool surfaces = HasSurfaces(features);
  vtkTextureSliceShadowSettings settings = asked;
  if (surfaces)
  {
    settings.Scattering = 0.0; // as in VTK's ray caster
    settings.Reach = 1.0;
  }
  this->Used = (settings.Shadow > 0.0 || settings.Occlusion > 0.0 || settings.Scattering > 0.0) &&
               CanShow(features);
  if (!this->Used)
  {
    return;
  }
  this->Strength = {static_cast<float>(settings.Shadow), static_cast<float>(settings.Occlusion)};
  this->HalfScattering = static_cast<float>(settings.Scattering / 2.0);
  const Lights lights = FindLights(source, settings);
  this->FindSurfaces(source, lights, settings.Density);
  Key key = MakeKey(source, lights, settings.Density);
  const bool finer = this->Coarse && !settings.Interactive;
  if (key != this->Last || finer)
  {
    const std::size_t mostCells = settings.Interactive ? MostCellsOfInteraction : MostCells;
    surfaces ? this->Volume.Build(MakeSurfaceSource(source, settings.Density), lights, mostCells)
             : this->Volume.Build(MakeSource(source, settings.Density), lights, mostCells);
    this->Coarse = settings.Interactive;
    this->Last = std::move(key);
    this->PlaceImage(source.Image, source.Frame->IsOfCells());
    this->Texture->ReleaseGraphicsResources(window);
  }
  // Surfaces and shading weigh shadow and occlusion apart.
  const bool apart = surfaces || source.Request->IsShaded();
  const std::array<float, 2> joined = apart ? std::array<float, 2>{} : this->Strength;
  const auto exposure = static_cast<float>(settings.Exposure);
  if (this->Texture->GetHandle() == 0 || joined != this->Joined || exposure != this->Exposure)
  {
    this->Joined = joined;
    this->Exposure = exposure;
    this->Upload(window);
  }
}

void vtkTextureSliceShadows::FindSurfaces(
  const Source& source, const Lights& lights, double density)
{
  this->Surfaces.clear();
  for (const auto& [value, depth] : MakeSurfaces(source, density))
  {
    this->Surfaces.push_back(static_cast<float>(Normalize(source, static_cast<double>(value))));
    this->Surfaces.push_back(1.0f - std::exp(-depth));
  }
  if (this->Surfaces.empty())
  {
    return;
  }
  this->InverseAspect = source.Frame->GetInverseAspect();
  // The shader weakens by the surfaces themselves, too: not without a light, or a sky.
  this->Strength = {
    lights.Shadow ? this->Strength[0] : 0.0f, lights.Occlusion ? this->Strength[1] : 0.0f};
  const double length = std::hypot(lights.ToLight[0], lights.ToLight[1], lights.ToLight[2]);
  std::transform(lights.ToLight.begin(), lights.ToLight.end(), this->ToLight.begin(),
    [&](double part) { return lights.Shadow ? static_cast<float>(part / length) : 0.0f; });
}

void vtkTextureSliceShadows::Upload(vtkOpenGLRenderWindow* window)
{
  const auto& size = this->Volume.GetGrid().Size;
  const bool apart = this->Joined == std::array<float, 2>{};
  this->Texture->ReleaseGraphicsResources(window);
  this->Texture->SetContext(window);
  this->Texture->ResetFormatAndType();
  this->Texture->SetInternalFormat(apart ? GL_RG16 : GL_R32F);
  this->Texture->SetWrapS(vtkTextureObject::ClampToEdge);
  this->Texture->SetWrapT(vtkTextureObject::ClampToEdge);
  this->Texture->SetWrapR(vtkTextureObject::ClampToEdge);
  this->Texture->SetMagnificationFilter(vtkTextureObject::Linear);
  this->Texture->SetMinificationFilter(vtkTextureObject::Linear);
  const auto create = [&](int channels, int type, void* texels)
  {
    this->Texture->Create3DFromRaw(static_cast<unsigned int>(size[0]),
      static_cast<unsigned int>(size[1]), static_cast<unsigned int>(size[2]), channels, type,
      texels);
  };
  if (apart)
  {
    std::vector<std::uint16_t> texels = this->Volume.GetTexels();
    create(2, VTK_UNSIGNED_SHORT, texels.data());
  }
  else
  {
    // Floats, because a software renderer converts all other texels whenever it reads them.
    std::vector<float> texels = this->Join();
    create(1, VTK_FLOAT, texels.data());
  }
}

/// What shadow and occlusion leave of a colour, for each cell (Formulas L2).
std::vector<float> vtkTextureSliceShadows::Join() const
{
  constexpr float full = 65535.0f;
  const std::vector<std::uint16_t>& light = this->Volume.GetTexels();
  const auto weaken = [](std::uint16_t texel, float strength)
  { return 1.0f - strength * (1.0f - static_cast<float>(texel) / full); };
  std::vector<float> left(light.size() / 2);
  for (std::size_t i = 0; i < left.size(); ++i)
  {
    left[i] = std::min(1.0f, this->Exposure * weaken(light[2 * i], this->Joined[0]) *
                               weaken(light[2 * i + 1], this->Joined[1]));
  }
  return left;
}

bool vtkTextureSliceShadows::IsScaled() const
{
  const std::array<float, 3> same{1.0f, 1.0f, 1.0f};
  return this->Used && this->Volume.GetGrid().GetTextureScale() != same;
}

void vtkTextureSliceShadows::PlaceImage(vtkImageData* volume, bool cellData)
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
}

vtkImageData* vtkTextureSliceShadows::GetImage()
{
  if (!this->Used)
  {
    return nullptr;
  }
  if (this->Image->GetPointData()->GetScalars() == nullptr)
  {
    const std::vector<std::uint16_t>& texels = this->Volume.GetTexels();
    vtkNew<vtkUnsignedShortArray> light;
    light->SetName("light");
    light->SetNumberOfComponents(2);
    light->SetNumberOfTuples(this->Image->GetNumberOfPoints());
    std::copy(texels.begin(), texels.end(), light->GetPointer(0));
    this->Image->GetPointData()->SetScalars(light);
  }
  return this->Image;
}

void vtkTextureSliceShadows::SetUniforms(vtkShaderProgram* program) const
{
  program->SetUniformi("lightTexture", this->Texture->GetTextureUnit());
  program->SetUniform3f("lightTextureScale", this->Volume.GetGrid().GetTextureScale().data());
  program->SetUniform2f("lightStrength", this->Strength.data());
  program->SetUniformf("scattering", this->HalfScattering);
  this->SetSurfaces(program);
}

void vtkTextureSliceShadows::SetSurfaces(vtkShaderProgram* program) const
{
  if (this->Surfaces.empty())
  {
    return;
  }
  const vtkTextureSliceLightGrid& grid = this->Volume.GetGrid();
  std::array<float, 3> toLight{};
  std::array<float, 3> gradientToCells{};
  std::array<float, 3> gradientToChange{};
  std::array<float, 3> cell{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    // The gradient is the change over two voxels, times the signed aspect of the shader.
    const float aspect = this->InverseAspect[axis];
    const float sign = aspect < 0.0f ? -1.0f : 1.0f;
    const auto edge = static_cast<float>(grid.CellEdge[axis]);
    toLight[axis] = this->ToLight[axis] / edge;
    gradientToCells[axis] = sign * edge;
    gradientToChange[axis] = 0.5f * static_cast<float>(grid.Factor[axis]) / aspect;
    cell[axis] = 1.0f / static_cast<float>(grid.Size[axis]);
  }
  vtkMath::Normalize(toLight.data());
  program->SetUniform3f("toLight", toLight.data());
  program->SetUniform3f("gradientToCells", gradientToCells.data());
  program->SetUniform3f("gradientToChange", gradientToChange.data());
  program->SetUniform3f("lightCell", cell.data());
  program->SetUniform2fv("lightSurfaces", static_cast<int>(this->Surfaces.size() / 2),
    reinterpret_cast<const float(*)[2]>(this->Surfaces.data()));
}

void vtkTextureSliceShadows::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Texture->ReleaseGraphicsResources(window);
}
