// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/VolumeAppearance.h"

#include "Scene/Frame/SceneFrame.h"
#include "nexrad/Settings/ValueTexts.h"
#include "nexrad/System/Error.h"
#include "vtkNexradColorMapSources.h"
#include "vtkNexradImageConversion.h"
#include "vtkNexradMessages.h"
#include "vtkNexradTransferFunction.h"
#include "vtkOpenGLTextureSliceVolumeMapper.h"

#include <vtkImageData.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkOpenGLGPUVolumeRayCastMapper.h>
#include <vtkPointData.h>
#include <vtkUnsignedCharArray.h>
#include <vtkVolumeProperty.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace nexrad::scene
{
namespace
{

// Light comes into cores far enough for their bright side to keep the colours of the colour bar.
// Surfaces take as much of it as their opacity says.
constexpr double shadowDensity = 0.35;
constexpr double shadowDensityOfSurfaces = 1.0;
// A side that sees the light and half of the sky keeps its colours.
constexpr double exposure = 1.25;

// What surfaces return of the light: VTK's own, and where there are shadows more of the ambient
// light, so that colours can be told apart in the shadow, and occlusion is seen.
struct Material
{
  double ambient;
  double diffuse;
};
constexpr Material usualMaterial{0.1, 0.7};
constexpr Material shadowedMaterial{0.4, 0.6};

// Width of the boxes of a colour bar for colours that have no steps.
double StepOfSplines(double span)
{
  if (!(span > 0.0) || (span >= 20.0 && span <= 120.0))
  {
    return 5.0;
  }
  const double least = span / 15.0;
  const double decade = std::pow(10.0, std::floor(std::log10(least)));
  return least <= decade         ? decade
         : least <= 2.0 * decade ? 2.0 * decade
         : least <= 5.0 * decade ? 5.0 * decade
                                 : 10.0 * decade;
}

// The array that a preset is for.
std::string ArrayOf(const std::string& preset)
{
  for (int i = 0; i < vtkNexradTransferFunction::GetNumberOfPresets(); ++i)
  {
    if (preset == vtkNexradTransferFunction::GetPresetName(i))
    {
      return vtkNexradTransferFunction::GetPresetArray(i);
    }
  }
  return "";
}

// The preset that the options name, or the moment's own.
std::string PresetFor(const SceneOptions& options, const std::string& array)
{
  const char* own = vtkNexradTransferFunction::FindPreset(array.c_str());
  const std::string usual = own != nullptr ? own : vtkNexradTransferFunction::GetPresetName(0);
  if (options.preset.empty())
  {
    return usual;
  }
  const std::string meant = ArrayOf(options.preset);
  if (!meant.empty() && own != nullptr && meant != array)
  {
    throw Error("preset '" + options.preset + "' is of " + meant + ", and " + array +
                " is shown; choose '" + usual + "' or no preset");
  }
  return options.preset;
}

// The surfaces of the lowest and of the highest of several values: the inner ones show through the
// outer ones. Those between are in between.
constexpr double outermostOpacity = 0.35;
constexpr double innermostOpacity = 0.95;

} // namespace

void RequireVoxels(vtkImageData* data, const SceneOptions& options)
{
  if (data == nullptr || data->GetNumberOfPoints() == 0 ||
      data->GetPointData()->GetScalars() == nullptr)
  {
    throw Error("the volume holds no voxels to draw");
  }
  const int* size = data->GetDimensions();
  if (!options.plan && std::min({size[0], size[1], size[2]}) < 2)
  {
    throw Error("the volume of " + DimensionsText({size[0], size[1], size[2]}) +
                " voxels is one layer without thickness; merge it with two layers or more "
                "(--dims), or draw it as a map (--map)");
  }
}

vtkSmartPointer<vtkImageData> AsDrawn(vtkImageData* data, const SceneOptions& options)
{
  const bool slices = options.mapper == MapperChoice::TextureSlice && options.colourBy.empty();
  const bool codes =
    vtkUnsignedCharArray::SafeDownCast(data->GetPointData()->GetScalars()) != nullptr;
  if (slices || options.plan || !codes)
  {
    return data;
  }
  auto values = vtkSmartPointer<vtkImageData>::New();
  vtkNexradVolumeToImage(vtkNexradImageToVolume(data), values);
  return values;
}

vtkSmartPointer<vtkVolumeMapper> MakeVolumeMapper(const SceneOptions& options)
{
  if (options.mapper == MapperChoice::TextureSlice)
  {
    auto slicer = vtkSmartPointer<vtkOpenGLTextureSliceVolumeMapper>::New();
    slicer->SetPreIntegration(options.preIntegration);
    slicer->SetMaxMemoryInBytes(static_cast<vtkIdType>(options.textureMemory));
    return slicer;
  }
  auto mapper = vtkSmartPointer<vtkOpenGLGPUVolumeRayCastMapper>::New();
  mapper->SetAutoAdjustSampleDistances(0);
  mapper->SetUseJittering(0);
  return mapper;
}

int SlicesFor(vtkImageData* placed)
{
  constexpr double voxelsForEach = 8.0 / 3.0; // a slab integrates over what lies between its faces
  constexpr double fewest = 128.0;
  constexpr double most = 1024.0;
  const CameraView view;
  const double azimuth = vtkMath::RadiansFromDegrees(view.azimuth);
  const double tilt = vtkMath::RadiansFromDegrees(view.tilt);
  const std::array<double, 3> direction = {
    std::sin(azimuth) * std::cos(tilt), std::cos(azimuth) * std::cos(tilt), std::sin(tilt)};
  double depth = 0.0;
  double shortest = 1e9; // along the view from one voxel to the next
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double along = std::abs(direction[axis]);
    const double edge = placed->GetSpacing()[axis];
    depth += along * edge * placed->GetDimensions()[axis];
    shortest = std::min(shortest, edge / along);
  }
  return static_cast<int>(std::clamp(std::round(depth / (voxelsForEach * shortest)), fewest, most));
}

void SetSlices(vtkVolumeMapper* mapper, int slices, double diagonal)
{
  if (auto* slicer = vtkOpenGLTextureSliceVolumeMapper::SafeDownCast(mapper))
  {
    slicer->SetNumberOfSlices(slices);
  }
  else if (auto* caster = vtkOpenGLGPUVolumeRayCastMapper::SafeDownCast(mapper))
  {
    caster->SetSampleDistance(static_cast<float>(diagonal / slices));
  }
}

void SetPixelSize(vtkVolumeMapper* mapper, double pixelsOfVoxel)
{
  constexpr double leastOfVoxel = 3.0;
  constexpr float largest = 1.5F;
  auto* slicer = vtkOpenGLTextureSliceVolumeMapper::SafeDownCast(mapper);
  if (slicer != nullptr)
  {
    const bool surfaces = slicer->GetBlendMode() == vtkVolumeMapper::ISOSURFACE_BLEND;
    slicer->SetImageSampleDistance(
      surfaces ? 1.0F
               : std::clamp(static_cast<float>(pixelsOfVoxel / leastOfVoxel), 1.0F, largest));
  }
}

void ShadeSurfaces(vtkVolumeProperty* property, bool surfaces, bool shadows)
{
  const Material& material = shadows ? shadowedMaterial : usualMaterial;
  property->SetShade(surfaces);
  property->SetAmbient(material.ambient);
  property->SetDiffuse(material.diffuse);
}

void SetLight(vtkVolumeMapper* mapper, const LightOptions& light, bool surfaces)
{
  mapper->SetBlendMode(
    surfaces ? vtkVolumeMapper::ISOSURFACE_BLEND : vtkVolumeMapper::COMPOSITE_BLEND);
  if (auto* slicer = vtkOpenGLTextureSliceVolumeMapper::SafeDownCast(mapper))
  {
    slicer->SetSmoothGradient(surfaces);
    const double azimuth = vtkMath::RadiansFromDegrees(light.direction.azimuth);
    const double elevation = vtkMath::RadiansFromDegrees(light.direction.elevation);
    slicer->SetShadowStrength(light.shadow);
    slicer->SetOcclusionStrength(light.occlusion);
    slicer->SetShadowDensity(surfaces ? shadowDensityOfSurfaces : shadowDensity);
    slicer->SetExposure(exposure);
    slicer->SetLightDirection(std::sin(azimuth) * std::cos(elevation),
      std::cos(azimuth) * std::cos(elevation), std::sin(elevation));
  }
}

vtkImageData* UpdateLight(vtkVolumeMapper* mapper, vtkRenderer* renderer, vtkVolume* volume)
{
  auto* slicer = vtkOpenGLTextureSliceVolumeMapper::SafeDownCast(mapper);
  return slicer != nullptr && slicer->UpdateLight(renderer, volume) ? slicer->GetLightVolume()
                                                                    : nullptr;
}

std::vector<IsoValue> IsoValuesOf(vtkNexradTransferFunction* transferFunction)
{
  std::vector<IsoValue> isoValues;
  for (int i = 0; i < transferFunction->GetNumberOfIsoValues(); ++i)
  {
    const double value = transferFunction->GetIsoValue(i);
    isoValues.push_back(
      {value, transferFunction->Evaluate(vtkNexradTransferFunction::OPACITY, value)});
  }
  return isoValues;
}

std::vector<IsoValue> WithOpacities(std::vector<IsoValue> isoValues)
{
  std::sort(isoValues.begin(), isoValues.end(),
    [](const IsoValue& a, const IsoValue& b) { return a.value < b.value; });
  const auto last = static_cast<double>(isoValues.size()) - 1.0;
  double place = 0.0;
  for (IsoValue& isoValue : isoValues)
  {
    const double rank = last > 0.0 ? place / last : 1.0;
    const double usual = outermostOpacity + rank * (innermostOpacity - outermostOpacity);
    isoValue.opacity = isoValue.opacity.value_or(usual);
    ++place;
  }
  return isoValues;
}

void SetIsoValues(std::vector<IsoValue> isoValues, vtkNexradTransferFunction* transferFunction)
{
  std::vector<double> values;
  std::vector<double> opacities;
  for (const IsoValue& isoValue : WithOpacities(std::move(isoValues)))
  {
    values.push_back(isoValue.value);
    opacities.push_back(*isoValue.opacity);
  }
  transferFunction->SetOpacityToIsoValues(
    values.data(), opacities.data(), static_cast<int>(values.size()));
}

namespace
{

constexpr int opacity = vtkNexradTransferFunction::OPACITY;

// Takes the opacities of a file, and its iso-values if it has any; the colours stay.
void TakeOpacities(const std::filesystem::path& path, vtkNexradTransferFunction* function)
{
  vtkNexradColorMap read;
  const std::string problem = vtkNexradReadColorMap(path, read);
  if (!problem.empty())
  {
    throw Error(path.string() + ": " + problem);
  }
  if (read.Channels[opacity].empty())
  {
    throw Error(path.string() + ": has no opacities; name a file that has some, such as one that "
                                "the window saved as .json");
  }
  function->RemoveAllNodes(opacity);
  for (const auto& [place, value] : read.Channels[opacity])
  {
    function->AddNode(opacity, place, value);
  }
  function->SetLinear(opacity, read.Linear[opacity]);
  std::vector<IsoValue> isoValues;
  for (const double value : read.IsoValues)
  {
    isoValues.push_back({value, function->Evaluate(opacity, value)});
  }
  if (!isoValues.empty())
  {
    SetIsoValues(std::move(isoValues), function);
  }
}

} // namespace

vtkSmartPointer<vtkNexradTransferFunction> MakeTransferFunction(
  const SceneOptions& options, const std::string& array)
{
  auto transferFunction = vtkSmartPointer<vtkNexradTransferFunction>::New();
  vtkNexradMessages messages;
  messages.Watch(transferFunction);
  transferFunction->ApplyPreset(PresetFor(options, array).c_str());
  if (!options.colours.empty() && options.colourBy.empty())
  {
    transferFunction->ReadFile(options.colours.c_str());
  }
  if (!options.opacities.empty())
  {
    TakeOpacities(options.opacities, transferFunction);
  }
  if (!options.isoValues.empty())
  {
    SetIsoValues(options.isoValues, transferFunction);
  }
  messages.ThrowFirstError();
  return transferFunction;
}

ColourTable ColourStepsOf(vtkNexradTransferFunction* transferFunction)
{
  ColourTable table;
  double range[2];
  Colour lower{};
  Colour upper{};
  for (int i = 0; transferFunction->GetBin(i, range, lower.data(), upper.data()); ++i)
  {
    table.push_back({range[0], lower});
    if (lower != upper)
    {
      table.back().ramp = ColourEnd{range[1], upper};
    }
  }
  if (table.size() >= 2)
  {
    return table;
  }
  table.clear();
  transferFunction->GetRange(range);
  const double step = StepOfSplines(range[1] - range[0]);
  const double first = std::floor(range[0] / step);
  for (double count = first; table.size() < 2 || count * step < range[1]; ++count)
  {
    const double from = count * step;
    const double middle = from + 0.5 * step;
    table.push_back({from, {transferFunction->Evaluate(vtkNexradTransferFunction::RED, middle),
                             transferFunction->Evaluate(vtkNexradTransferFunction::GREEN, middle),
                             transferFunction->Evaluate(vtkNexradTransferFunction::BLUE, middle)}});
  }
  return table;
}

namespace
{

// Writes the values of a scale as the labels of a colour table do.
void SetLabels(vtkNexradTransferFunction* look, ColourScale& scale)
{
  const auto [unit, factor, offset] = LabelUnitOf(look, scale.unit);
  if (factor != look->GetLabelFactor() || offset != look->GetLabelOffset())
  {
    return; // its step is in the unit that is not known
  }
  scale.unit = unit;
  scale.factor = factor;
  scale.offset = offset;
  scale.step = look->GetLabelStep();
  scale.decimals = look->GetLabelDecimals();
  for (ColourBin& bin : scale.bins)
  {
    bin.from = bin.from * factor + offset;
    if (bin.ramp)
    {
      bin.ramp->at = bin.ramp->at * factor + offset;
    }
  }
}

} // namespace

LabelUnit LabelUnitOf(const vtkNexradTransferFunction* look, const std::string& ofData)
{
  const std::string unit = look != nullptr ? look->GetLabelUnit() : "";
  const double factor = look != nullptr ? look->GetLabelFactor() : 1.0;
  const double offset = look != nullptr ? look->GetLabelOffset() : 0.0;
  const bool other = factor != 1.0 || offset != 0.0;
  if (other && !unit.empty() && factor > 0.0)
  {
    return {unit, factor, offset};
  }
  return {!other && ofData.empty() ? unit : ofData};
}

ColourScale ScaleOf(const std::string& array, vtkNexradTransferFunction* transferFunction)
{
  ColourScale scale = MomentScale(array, ColourStepsOf(transferFunction));
  SetLabels(transferFunction, scale);
  Colour rangeFolded{};
  if (transferFunction->GetRangeFoldedColor(rangeFolded.data()))
  {
    scale.rangeFolded = rangeFolded;
  }
  return scale;
}

std::vector<std::string> LinesPassedOver(const SceneOptions& options)
{
  std::vector<std::string> lines;
  for (const auto& path : {options.colours, options.opacities})
  {
    if (!path.empty() && (lines.empty() || path != options.colours))
    {
      vtkNexradColorMap read;
      if (vtkNexradReadColorMap(path, read).empty())
      {
        for (const std::string& line : read.PassedOver)
        {
          lines.push_back(path.string() + ": passed over: " + line);
        }
      }
    }
  }
  return lines;
}

vtkSmartPointer<vtkVolumeProperty> MakeVolumeProperty()
{
  auto property = vtkSmartPointer<vtkVolumeProperty>::New();
  property->SetScalarOpacityUnitDistance(OpacityUnitDistance);
  property->SetInterpolationTypeToLinear();
  property->ShadeOff();
  return property;
}

} // namespace nexrad::scene
