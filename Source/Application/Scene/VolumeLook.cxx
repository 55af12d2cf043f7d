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
// Chosen so that 80 km of scene through stratiform rain of 30 dBZ lets a third of the map through,
// and 12 km through a core of 50 dBZ a tenth.
constexpr OpacityNode opacityNodes[] = {{8.0, 0.006}, {15.0, 0.015}, {20.0, 0.028}, {30.0, 0.065},
  {40.0, 0.25}, {50.0, 0.60}, {60.0, 0.85}, {75.0, 0.95}};

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
