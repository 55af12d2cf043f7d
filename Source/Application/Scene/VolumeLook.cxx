// SPDX-License-Identifier: BSD-3-Clause
#include "VolumeLook.h"

#include "Volumes/VtkMessages.h"
#include "vtkNexradTransferFunction.h"
#include "vtkOpenGLTextureSliceVolumeMapper.h"

#include <vtkOpenGLGPUVolumeRayCastMapper.h>
#include <vtkVolumeProperty.h>

#include <algorithm>
#include <cmath>

namespace nexrad::scene
{
namespace
{

constexpr double unitDistance = 5.0;  // scene units: km along the ground
constexpr double stepOfSplines = 5.0; // dBZ, of a colour bar for colours that have no steps

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

vtkSmartPointer<vtkNexradTransferFunction> MakeLook(const SceneOptions& options)
{
  auto look = vtkSmartPointer<vtkNexradTransferFunction>::New();
  application::VtkMessages messages;
  messages.Watch(look);
  look->ApplyPreset(options.preset.c_str());
  if (!options.colours.empty())
  {
    look->ReadFile(options.colours.c_str());
  }
  messages.ThrowFirstError();
  return look;
}

ColourTable StepsOf(vtkNexradTransferFunction* look)
{
  ColourTable table;
  double range[2];
  Colour lower{};
  Colour upper{};
  for (int i = 0; look->GetBin(i, range, lower.data(), upper.data()); ++i)
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
  look->GetRange(range);
  const double first = std::floor(range[0] / stepOfSplines) * stepOfSplines;
  for (double from = first; table.size() < 2 || from < range[1]; from += stepOfSplines)
  {
    const double middle = from + 0.5 * stepOfSplines;
    table.push_back({from, {look->Evaluate(vtkNexradTransferFunction::RED, middle),
                             look->Evaluate(vtkNexradTransferFunction::GREEN, middle),
                             look->Evaluate(vtkNexradTransferFunction::BLUE, middle)}});
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
