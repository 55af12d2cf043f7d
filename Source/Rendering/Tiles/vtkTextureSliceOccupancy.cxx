// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSliceOccupancy.h"

#include <algorithm>
#include <cmath>

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

vtkTextureSliceOccupancy::Share vtkTextureSliceOccupancy::Find(
  const std::array<double, 3>& low, const std::array<double, 3>& high) const
{
  std::array<int, 3> begin;
  std::array<int, 3> end;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double from = low[axis] - PositionError;
    const double to = high[axis] + PositionError;
    if (to < 0.0 || from > 1.0)
    {
      return Share::Nothing;
    }
    const int last = this->Count[axis] - 1;
    begin[axis] = std::min(last, static_cast<int>(std::max(0.0, from) * this->PerBox[axis]));
    end[axis] = std::min(last, static_cast<int>(std::min(1.0, to) * this->PerBox[axis])) + 1;
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
