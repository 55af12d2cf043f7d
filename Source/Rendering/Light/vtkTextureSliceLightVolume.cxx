// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSliceLightVolume.h"

#include "vtkMath.h"
#include "vtkSMPTools.h"
#include "vtkTextureSliceLightSweep.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace
{

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

} // namespace

std::array<std::array<double, 3>, vtkTextureSliceLightVolume::SkyDirections>
vtkTextureSliceLightVolume::GetSkyDirections()
{
  // A spiral with one direction in each of equal slices of height, turned by the golden angle.
  const double turn = vtkMath::Pi() * (3.0 - std::sqrt(5.0));
  std::array<std::array<double, 3>, SkyDirections> directions{};
  for (std::size_t i = 0; i < SkyDirections; ++i)
  {
    const double height = (static_cast<double>(i) + 0.5) / SkyDirections;
    const double radius = std::sqrt(1.0 - height * height);
    const double angle = turn * static_cast<double>(i);
    directions[i] = {radius * std::cos(angle), radius * std::sin(angle), height};
  }
  return directions;
}

void vtkTextureSliceLightVolume::Build(
  const vtkTextureSliceExtinction::Source& source, const Lights& lights, bool coarse)
{
  vtkTextureSliceExtinction extinction;
  extinction.Build(source, coarse);
  this->Grid = extinction.GetGrid();
  this->Texels.assign(2 * this->Grid.CountCells(), FullLight);
  vtkTextureSliceLightSweep sweep(extinction);
  if (lights.Shadow)
  {
    sweep.Add(lights.ToLight, 1.0);
    SetComponent(sweep.TakeSums(), 0, this->Texels);
  }
  if (lights.Occlusion)
  {
    for (const auto& direction : GetSkyDirections())
    {
      std::array<double, 3> towards{};
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        towards[axis] = lights.Sky[0][axis] * direction[0] + lights.Sky[1][axis] * direction[1] +
                        lights.Sky[2][axis] * direction[2];
      }
      sweep.Add(towards, 1.0 / SkyDirections);
    }
    SetComponent(sweep.TakeSums(), 1, this->Texels);
  }
}
