// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/VolumeAppearance.h"

#include "nexrad/System/Error.h"
#include "vtkNexradMessages.h"
#include "vtkNexradTransferFunction.h"
#include "vtkOpenGLTextureSliceVolumeMapper.h"

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

vtkSmartPointer<vtkVolumeMapper> MakeVolumeMapper(MapperChoice choice)
{
  if (choice == MapperChoice::TextureSlice)
  {
    return vtkSmartPointer<vtkOpenGLTextureSliceVolumeMapper>::New();
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
