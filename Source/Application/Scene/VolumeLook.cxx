// SPDX-License-Identifier: BSD-3-Clause
#include "VolumeLook.h"

#include "vtkOpenGLTextureSliceVolumeMapper.h"

#include <vtkColorTransferFunction.h>
#include <vtkNew.h>
#include <vtkOpenGLGPUVolumeRayCastMapper.h>
#include <vtkPiecewiseFunction.h>
#include <vtkVolumeProperty.h>

namespace nexrad::scene
{
namespace
{

struct OpacityNode
{
  double dBZ;
  double opacity; // of unitDistance
};
constexpr double unitDistance = 5.0; // scene units: km along the ground
// Chosen so that 40 km of scene (5 km of height, stretched 8 times) through rain of 20 dBZ hide
// four tenths of the map, through 30 dBZ seven tenths, and that 10 km through a core of 50 dBZ
// look solid.
constexpr OpacityNode opacityNodes[] = {{10.0, 0.025}, {20.0, 0.065}, {30.0, 0.14}, {40.0, 0.25},
  {50.0, 0.75}, {60.0, 0.93}, {75.0, 0.98}};

} // namespace

vtkSmartPointer<vtkVolumeMapper> MakeVolumeMapper(MapperChoice choice, int slices, double diagonal)
{
  if (choice == MapperChoice::TextureSlice)
  {
    auto mapper = vtkSmartPointer<vtkOpenGLTextureSliceVolumeMapper>::New();
    mapper->SetNumberOfSlices(slices);
    return mapper;
  }
  auto mapper = vtkSmartPointer<vtkOpenGLGPUVolumeRayCastMapper>::New();
  mapper->SetAutoAdjustSampleDistances(0);
  mapper->SetSampleDistance(static_cast<float>(diagonal / slices));
  mapper->SetUseJittering(0);
  return mapper;
}

vtkSmartPointer<vtkVolumeProperty> MakeVolumeProperty(const ColourTable& table)
{
  vtkNew<vtkColorTransferFunction> colours;
  FillSmooth(colours, table);
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(table.front().from, 0.0);
  for (const OpacityNode& node : opacityNodes)
  {
    if (node.dBZ > table.front().from)
    {
      opacity->AddPoint(node.dBZ, node.opacity);
    }
  }
  auto property = vtkSmartPointer<vtkVolumeProperty>::New();
  property->SetColor(colours);
  property->SetScalarOpacity(opacity);
  property->SetScalarOpacityUnitDistance(unitDistance);
  property->SetInterpolationTypeToLinear();
  property->ShadeOff();
  return property;
}

} // namespace nexrad::scene
