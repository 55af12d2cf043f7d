// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSliceLightVolume.h"

#include "vtkMath.h"
#include "vtkTextureSliceLightSweep.h"

#include <cmath>
#include <cstddef>

std::vector<std::array<double, 3>> vtkTextureSliceLightVolume::GetSkyDirections(int count)
{
  // A spiral with one direction in each of equal slices of height, turned by the golden angle.
  const double turn = vtkMath::Pi() * (3.0 - std::sqrt(5.0));
  std::vector<std::array<double, 3>> directions;
  for (int i = 0; i < count; ++i)
  {
    const double height = (i + 0.5) / count;
    const double radius = std::sqrt(1.0 - height * height);
    const double angle = turn * i;
    directions.push_back({radius * std::cos(angle), radius * std::sin(angle), height});
  }
  return directions;
}

void vtkTextureSliceLightVolume::Build(
  const vtkTextureSliceLightCells::Source& source, const Lights& lights, std::size_t mostCells)
{
  const vtkTextureSliceLightCells cells(source, mostCells);
  this->Grid = cells.GetGrid();
  std::vector<float> shadow(this->Grid.CountCells(), lights.Shadow ? 0.0f : 1.0f);
  std::vector<float> occlusion(this->Grid.CountCells(), lights.Occlusion ? 0.0f : 1.0f);
  if (lights.Shadow)
  {
    vtkTextureSliceLightSweep::Add(cells, lights.ToLight, 1.0, shadow);
  }
  if (lights.Occlusion)
  {
    const int count = source.Surfaces.empty() ? SkyDirections : SkyDirectionsOfSurfaces;
    for (const auto& direction : GetSkyDirections(count))
    {
      std::array<double, 3> towards{};
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        towards[axis] = lights.Sky[0][axis] * direction[0] + lights.Sky[1][axis] * direction[1] +
                        lights.Sky[2][axis] * direction[2];
      }
      vtkTextureSliceLightSweep::Add(cells, towards, 1.0 / count, occlusion);
    }
  }
  this->Light = vtkSmartPointer<vtkFloatArray>::New();
  this->Light->SetName("light");
  this->Light->SetNumberOfComponents(2);
  this->Light->SetNumberOfTuples(static_cast<vtkIdType>(shadow.size()));
  float* light = this->Light->GetPointer(0);
  for (std::size_t i = 0; i < shadow.size(); ++i)
  {
    *light++ = shadow[i];
    *light++ = occlusion[i];
  }
}
