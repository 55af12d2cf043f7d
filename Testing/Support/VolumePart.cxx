// SPDX-License-Identifier: BSD-3-Clause
#include "VolumePart.h"

#include <algorithm>
#include <utility>

namespace nexrad::testing
{

namespace
{

// The values of a block, in place: a value moves towards the front, or stays.
template <class Value>
void KeepBlock(std::vector<Value>& values, const GridSpecification& grid, const VoxelBlock& block)
{
  if (values.empty())
  {
    return;
  }
  auto to = values.begin();
  for (int z = block.begin[2]; z < block.end[2]; ++z)
  {
    for (int y = block.begin[1]; y < block.end[1]; ++y)
    {
      const std::ptrdiff_t row = static_cast<std::ptrdiff_t>(z) * grid.dimensions[1] + y;
      const auto from = values.begin() + row * grid.dimensions[0] + block.begin[0];
      to = from == to ? from + block.Size(0) : std::copy(from, from + block.Size(0), to);
    }
  }
  values.erase(to, values.end());
}

} // namespace

GriddedVolume TakePart(GriddedVolume volume, const VoxelBlock& block)
{
  const GridSpecification part = PartOf(volume.grid, block);
  KeepBlock(volume.values, volume.grid, block);
  KeepBlock(volume.states, volume.grid, block);
  ForEachAncillaryArray(
    volume.ancillary, [&](const char*, auto& values) { KeepBlock(values, volume.grid, block); });
  volume.grid = part;
  for (GriddedVolume& further : volume.further)
  {
    further = TakePart(std::move(further), block);
  }
  return volume;
}

} // namespace nexrad::testing
