// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Thesis/ColumnFilling.h"

#include <cmath>

namespace nexrad
{

namespace
{

// One column in the array: every `stride`-th value.
struct Column
{
  float* first;
  std::size_t stride;

  float& At(std::size_t level) const { return first[level * stride]; }
};

void FillColumn(const Column& column, std::size_t levels)
{
  std::size_t next = 0; // lowest level not yet dealt with
  for (std::size_t level = 0; level < levels; ++level)
  {
    const float value = column.At(level);
    if (std::isnan(value))
    {
      continue;
    }
    const bool lowest = next == 0;
    const float below = lowest ? value : column.At(next - 1);
    const auto gap = static_cast<float>(level - next + 1);
    for (std::size_t empty = next; empty < level; ++empty)
    {
      const float part = static_cast<float>(empty - next + 1) / gap;
      column.At(empty) = lowest ? value : below + part * (value - below);
    }
    next = level + 1;
  }
}

} // namespace

void FillColumns(std::vector<float>& values, const std::array<int, 3>& dimensions,
  std::size_t begin, std::size_t end)
{
  const auto stride =
    static_cast<std::size_t>(dimensions[0]) * static_cast<std::size_t>(dimensions[1]);
  for (std::size_t column = begin; column < end; ++column)
  {
    FillColumn({values.data() + column, stride}, static_cast<std::size_t>(dimensions[2]));
  }
}

} // namespace nexrad
