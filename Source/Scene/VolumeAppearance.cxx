// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/VolumeAppearance.h"

#include "nexrad/System/Error.h"
#include "vtkNexradMessages.h"
#include "vtkNexradTransferFunction.h"
#include "vtkOpenGLTextureSliceVolumeMapper.h"

#include <vtkMath.h>
#include <vtkOpenGLGPUVolumeRayCastMapper.h>
#include <vtkVolumeProperty.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace nexrad::scene
{
namespace
{

constexpr double unitDistance = 5.0; // scene units: km along the ground

// Light comes into cores far enough for their bright side to keep the colours of the colour bar.
constexpr double shadowDensity = 0.35;

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
  const std::string usual = own != nullptr ? own : presetNames[0];
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

} // namespace

vtkSmartPointer<vtkVolumeMapper> MakeVolumeMapper(MapperChoice choice, bool preIntegration)
{
  if (choice == MapperChoice::TextureSlice)
  {
    auto slicer = vtkSmartPointer<vtkOpenGLTextureSliceVolumeMapper>::New();
    slicer->SetPreIntegration(preIntegration);
    return slicer;
  }
  auto mapper = vtkSmartPointer<vtkOpenGLGPUVolumeRayCastMapper>::New();
  mapper->SetAutoAdjustSampleDistances(0);
  mapper->SetUseJittering(0);
  return mapper;
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

void DrawSurfaces(vtkVolumeMapper* mapper, bool surfaces)
{
  mapper->SetBlendMode(
    surfaces ? vtkVolumeMapper::ISOSURFACE_BLEND : vtkVolumeMapper::COMPOSITE_BLEND);
  if (auto* slicer = vtkOpenGLTextureSliceVolumeMapper::SafeDownCast(mapper))
  {
    slicer->SetSmoothGradient(surfaces);
  }
}

void SetLight(vtkVolumeMapper* mapper, const LightOptions& light)
{
  if (auto* slicer = vtkOpenGLTextureSliceVolumeMapper::SafeDownCast(mapper))
  {
    const double azimuth = vtkMath::RadiansFromDegrees(light.direction.azimuth);
    const double elevation = vtkMath::RadiansFromDegrees(light.direction.elevation);
    slicer->SetShadowStrength(light.shadow);
    slicer->SetOcclusionStrength(light.occlusion);
    slicer->SetShadowDensity(shadowDensity);
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

bool Upload(vtkVolumeMapper* mapper, vtkRenderer* renderer, vtkVolume* volume)
{
  if (auto* slicer = vtkOpenGLTextureSliceVolumeMapper::SafeDownCast(mapper))
  {
    return slicer->PreLoadData(renderer, volume);
  }
  auto* caster = vtkOpenGLGPUVolumeRayCastMapper::SafeDownCast(mapper);
  return caster != nullptr && caster->PreLoadData(renderer, volume);
}

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
    Colour mean{};
    std::transform(lower.begin(), lower.end(), upper.begin(), mean.begin(),
      [](double a, double b) { return 0.5 * (a + b); });
    table.push_back({range[0], mean});
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

vtkSmartPointer<vtkVolumeProperty> MakeVolumeProperty()
{
  auto property = vtkSmartPointer<vtkVolumeProperty>::New();
  property->SetScalarOpacityUnitDistance(unitDistance);
  property->SetInterpolationTypeToLinear();
  property->ShadeOff();
  return property;
}

} // namespace nexrad::scene
