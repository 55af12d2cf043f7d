// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSliceLightGrid.h"

#include <algorithm>

vtkTextureSliceLightGrid vtkTextureSliceLightGrid::Choose(const std::array<int, 3>& voxels,
  bool cellData, const std::array<double, 3>& voxelEdge, std::size_t mostCells)
{
  vtkTextureSliceLightGrid grid;
  grid.Voxels = voxels;
  grid.Size = voxels;
  grid.CellEdge = voxelEdge;
  grid.CellData = cellData;
  while (grid.CountCells() > mostCells)
  {
    const auto shortest = static_cast<std::size_t>(
      std::min_element(grid.CellEdge.begin(), grid.CellEdge.end()) - grid.CellEdge.begin());
    // An axis of one cell has nothing left to give.
    const auto longest = static_cast<std::size_t>(
      std::max_element(grid.Size.begin(), grid.Size.end()) - grid.Size.begin());
    const std::size_t axis = grid.Size[shortest] > 1 ? shortest : longest;
    if (grid.Size[axis] == 1)
    {
      break;
    }
    grid.Factor[axis] *= 2;
    grid.CellEdge[axis] *= 2.0;
    grid.Size[axis] = (voxels[axis] + grid.Factor[axis] - 1) / grid.Factor[axis];
  }
  return grid;
}

std::size_t vtkTextureSliceLightGrid::CountCells() const
{
  return static_cast<std::size_t>(this->Size[0]) * static_cast<std::size_t>(this->Size[1]) *
         static_cast<std::size_t>(this->Size[2]);
}

vtkTextureSliceLightGrid::Rows vtkTextureSliceLightGrid::GetRows(int cell, std::size_t axis) const
{
  constexpr int mostRows = 4;
  const int inset = std::max(0, (this->Factor[axis] - mostRows) / 2);
  const int end = std::min(this->Voxels[axis], (cell + 1) * this->Factor[axis] - inset);
  return {std::min(cell * this->Factor[axis] + inset, end - 1), end};
}

double vtkTextureSliceLightGrid::GetPlace(int cell, std::size_t axis) const
{
  const double low = this->GetMargin(axis, false);
  const double intervals = low + this->Size[axis] - 1 + this->GetMargin(axis, true);
  return (cell + low) / intervals;
}

double vtkTextureSliceLightGrid::GetMargin(std::size_t axis, bool high) const
{
  const double factor = this->Factor[axis];
  const double face = this->CellData ? 0.5 : 0.0; // voxels beyond the centre of the outermost one
  const double centre =
    high ? factor * (this->Size[axis] - 1) + (factor - 1.0) / 2.0 : (factor - 1.0) / 2.0;
  return (high ? this->Voxels[axis] - 1 + face - centre : centre + face) / factor;
}

std::array<float, 3> vtkTextureSliceLightGrid::GetTextureScale() const
{
  std::array<float, 3> scale{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    scale[axis] = static_cast<float>(this->Voxels[axis]) /
                  static_cast<float>(this->Factor[axis] * this->Size[axis]);
  }
  return scale;
}
