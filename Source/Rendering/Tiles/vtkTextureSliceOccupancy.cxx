// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSliceOccupancy.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace
{

/// What the graphics hardware may err by in a sample's position, in box coordinates.
constexpr double PositionError = 1e-6;

} // namespace

vtkTextureSliceOccupancy::vtkTextureSliceOccupancy()
{
  this->Build({1, 1, 1}, {1.0, 1.0, 1.0}, {1});
}

void vtkTextureSliceOccupancy::Build(const std::array<int, 3>& count,
  const std::array<double, 3>& edge, const std::vector<unsigned char>& visible)
{
  this->Count = count;
  this->Borders = {};
  this->Margin = PositionError;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    this->PerBox[axis] = 1.0 / edge[axis];
  }
  this->VisibleBefore.assign(this->At(count[0], count[1], count[2]) + 1, 0);
  const unsigned char* brick = visible.data();
  for (int z = 0; z < count[2]; ++z)
  {
    for (int y = 0; y < count[1]; ++y)
    {
      int row = 0;
      for (int x = 0; x < count[0]; ++x, ++brick)
      {
        row += *brick != 0 ? 1 : 0;
        this->VisibleBefore[this->At(x + 1, y + 1, z + 1)] =
          row + this->VisibleBefore[this->At(x + 1, y, z + 1)] +
          this->VisibleBefore[this->At(x + 1, y + 1, z)] -
          this->VisibleBefore[this->At(x + 1, y, z)];
      }
    }
  }
}

void vtkTextureSliceOccupancy::SetBorders(std::array<std::vector<double>, 3> borders, double margin)
{
  this->Borders = std::move(borders);
  this->Margin = margin;
}

int vtkTextureSliceOccupancy::FindBrick(std::size_t axis, double place) const
{
  const std::vector<double>& borders = this->Borders[axis];
  const auto beyond = std::upper_bound(borders.begin(), borders.end(), place);
  return std::max(0, static_cast<int>(beyond - borders.begin()) - 1);
}

vtkTextureSliceOccupancy::Share vtkTextureSliceOccupancy::Find(
  const std::array<double, 3>& low, const std::array<double, 3>& high) const
{
  std::array<int, 3> begin;
  std::array<int, 3> end;
  // A frame asks this many thousand times.
  const bool even = this->Borders[0].empty();
  const auto find = [&](std::size_t axis, double place)
  { return even ? static_cast<int>(place * this->PerBox[axis]) : this->FindBrick(axis, place); };
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double from = low[axis] - this->Margin;
    const double to = high[axis] + this->Margin;
    if (to < 0.0 || from > 1.0)
    {
      return Share::Nothing;
    }
    const int last = this->Count[axis] - 1;
    begin[axis] = std::min(last, find(axis, std::max(0.0, from)));
    end[axis] = std::min(last, find(axis, std::min(1.0, to))) + 1;
  }
  const auto before = [&](int x, int y, int z) { return this->VisibleBefore[this->At(x, y, z)]; };
  const int visible = before(end[0], end[1], end[2]) - before(begin[0], end[1], end[2]) -
                      before(end[0], begin[1], end[2]) - before(end[0], end[1], begin[2]) +
                      before(begin[0], begin[1], end[2]) + before(begin[0], end[1], begin[2]) +
                      before(end[0], begin[1], begin[2]) - before(begin[0], begin[1], begin[2]);
  if (visible == 0)
  {
    return Share::Nothing;
  }
  const int all = (end[0] - begin[0]) * (end[1] - begin[1]) * (end[2] - begin[2]);
  return visible == all ? Share::Everything : Share::Something;
}
