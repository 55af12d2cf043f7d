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

void SetComponent(
  const std::vector<float>& light, std::size_t component, std::vector<std::uint16_t>& texels)
{
  constexpr float full = vtkTextureSliceLightVolume::FullLight;
  vtkSMPTools::For(0, static_cast<vtkIdType>(light.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
      {
        const float rounded = light[i] * full + 0.5f;
        texels[2 * i + component] =
          static_cast<std::uint16_t>(static_cast<int>(rounded < full ? rounded : full));
      }
    });
}

/// A sampled quantity between the centres of cells, beyond them that of the outermost ones.
class Interpolation
{
public:
  Interpolation(const std::vector<float>& values, const std::array<int, 3>& size)
    : Values(values)
    , Size(size)
  {
  }

  float operator()(const std::array<double, 3>& at) const
  {
    std::array<std::size_t, 3> low{};
    std::array<float, 3> fraction{};
    std::array<std::size_t, 3> next{};
    std::size_t stride = 1;
    std::size_t first = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const double inside = std::clamp(at[axis], 0.0, this->Size[axis] - 1.0);
      low[axis] = static_cast<std::size_t>(inside);
      fraction[axis] = static_cast<float>(inside - static_cast<double>(low[axis]));
      next[axis] = fraction[axis] > 0.0f ? stride : 0;
      first += low[axis] * stride;
      stride *= static_cast<std::size_t>(this->Size[axis]);
    }
    float sum = 0.0f;
    for (std::size_t corner = 0; corner < 8; ++corner)
    {
      float weight = 1.0f;
      std::size_t place = first;
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        const bool upper = (corner >> axis & 1) != 0;
        weight *= upper ? fraction[axis] : 1.0f - fraction[axis];
        place += upper ? next[axis] : 0;
      }
      sum += weight * this->Values[place];
    }
    return sum;
  }

private:
  const std::vector<float>& Values;
  const std::array<int, 3> Size;
};

/// Leaves, of the way that light takes to each cell, the part next to the cell: the transmittance
/// of the whole way over that of the rest.
void LimitReach(
  const vtkTextureSliceLightGrid& grid, const Lights& lights, std::vector<float>& light)
{
  constexpr float nothing = 1e-9f;
  const std::vector<float> whole = light;
  const Interpolation interpolation(whole, grid.Size);
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
    return kept < steps ? interpolation(at) : 1.0f;
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
  const vtkTextureSliceExtinction::Source& source, const Lights& lights, std::size_t mostCells)
{
  vtkTextureSliceExtinction extinction;
  extinction.Build(source, mostCells);
  this->Grid = extinction.GetGrid();
  vtkTextureSliceLightSweep sweep(extinction);
  this->Fill(sweep, lights, SkyDirections);
}

void vtkTextureSliceLightVolume::Build(
  const vtkTextureSliceSurfaceScalars::Source& source, const Lights& lights, std::size_t mostCells)
{
  vtkTextureSliceSurfaceScalars scalars;
  scalars.Build(source, mostCells);
  this->Grid = scalars.GetGrid();
  vtkTextureSliceLightSweep sweep(scalars, source.Surfaces);
  this->Fill(sweep, lights, SkyDirectionsOfSurfaces);
}

void vtkTextureSliceLightVolume::Fill(
  vtkTextureSliceLightSweep& sweep, const Lights& lights, int skyDirections)
{
  this->Texels.assign(2 * this->Grid.CountCells(), FullLight);
  if (lights.Shadow)
  {
    sweep.Add(lights.ToLight, 1.0);
    std::vector<float> light = sweep.TakeSums();
    if (lights.Reach < 1.0)
    {
      LimitReach(this->Grid, lights, light);
    }
    SetComponent(light, 0, this->Texels);
  }
  if (lights.Occlusion)
  {
    for (const auto& direction : GetSkyDirections(skyDirections))
    {
      std::array<double, 3> towards{};
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        towards[axis] = lights.Sky[0][axis] * direction[0] + lights.Sky[1][axis] * direction[1] +
                        lights.Sky[2][axis] * direction[2];
      }
      sweep.Add(towards, 1.0 / skyDirections);
    }
    SetComponent(sweep.TakeSums(), 1, this->Texels);
  }
}
