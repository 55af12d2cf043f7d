// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSliceLightVolume.h"

#include "vtkMath.h"
#include "vtkSMPTools.h"
#include "vtkTextureSliceLightSweep.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace
{

using Lights = vtkTextureSliceLightVolume::Lights;

/// Light between the centres of cells, beyond them that of the outermost ones.
float Interpolate(
  const std::vector<float>& light, const std::array<int, 3>& size, const std::array<double, 3>& at)
{
  std::array<vtkIdType, 3> low{};
  std::array<float, 3> fraction{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double inside = std::clamp(at[axis], 0.0, size[axis] - 1.0);
    low[axis] = static_cast<vtkIdType>(inside);
    fraction[axis] = static_cast<float>(inside - static_cast<double>(low[axis]));
  }
  float sum = 0.0f;
  for (int corner = 0; corner < 8; ++corner)
  {
    float weight = 1.0f;
    std::array<vtkIdType, 3> cell{};
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const bool upper = (corner >> axis & 1) != 0;
      weight *= upper ? fraction[axis] : 1.0f - fraction[axis];
      cell[axis] = std::min(low[axis] + (upper ? 1 : 0), vtkIdType{size[axis] - 1});
    }
    sum +=
      weight * light[static_cast<std::size_t>((cell[2] * size[1] + cell[1]) * size[0] + cell[0])];
  }
  return sum;
}

/// Leaves, of the way that light takes to each cell, the part next to the cell: the transmittance
/// of the whole way over that of the rest.
void LimitReach(
  const vtkTextureSliceLightGrid& grid, const Lights& lights, std::vector<float>& light)
{
  constexpr float nothing = 1e-9f;
  const std::vector<float> whole = light;
  const double length = std::hypot(lights.ToLight[0], lights.ToLight[1], lights.ToLight[2]);
  std::array<double, 3> towards{}; // in cells, one of them along the axis of the most
  double most = 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    towards[axis] = lights.ToLight[axis] / (length * grid.CellEdge[axis]);
    most = std::max(most, std::abs(towards[axis]));
  }
  const auto limit = [&](std::array<double, 3> at)
  {
    double steps = std::numeric_limits<double>::infinity(); // to the face
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const double room = towards[axis] > 0.0
                            ? grid.Size[axis] - 1 - at[axis] + grid.GetMargin(axis, true)
                            : at[axis] + grid.GetMargin(axis, false);
      steps = towards[axis] != 0.0 ? std::min(steps, room * most / std::abs(towards[axis])) : steps;
    }
    const double kept = std::max(1.0, lights.Reach * steps);
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      at[axis] += kept * towards[axis] / most;
    }
    return kept < steps ? Interpolate(whole, grid.Size, at) : 1.0f;
  };
  vtkSMPTools::For(0, static_cast<vtkIdType>(light.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        const vtkIdType row = i / grid.Size[0];
        const float rest =
          limit({double(i % grid.Size[0]), double(row % grid.Size[1]), double(row / grid.Size[1])});
        float& here = light[static_cast<std::size_t>(i)];
        here = here > nothing ? std::min(1.0f, here / rest) : 0.0f;
      }
    });
}

} // namespace

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
    if (lights.Reach < 1.0)
    {
      LimitReach(this->Grid, lights, shadow);
    }
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
