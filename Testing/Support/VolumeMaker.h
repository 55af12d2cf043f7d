// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Grid/GriddedVolume.h"

namespace nexrad::testing
{

/// A small volume with every state but range folded: one voxel in three is not scanned, one in
/// three has no echo, the others hold 0.75 dBZ more each.
inline GriddedVolume MakeGriddedVolume(std::array<int, 3> dimensions = {5, 4, 3})
{
  GriddedVolume volume;
  volume.grid.dimensions = dimensions;
  volume.grid.origin = {-1000.5, 250.0, 78.125};
  volume.grid.spacing = {1800.25, 1700.0, 156.25};
  volume.grid.centreLatitude = 39.21;
  volume.grid.centreLongitude = -91.7;
  volume.time = *ParseIso8601("2006-03-12T18:05:00.250Z");
  volume.method = "beam";
  volume.sites = {"KEAX", "KLSX"};
  volume.fill = -33.0F;
  for (std::size_t i = 0; i < volume.grid.VoxelCount(); ++i)
  {
    const bool echo = i % 3 == 0;
    volume.states.push_back(echo         ? VoxelState::Echo
                            : i % 3 == 1 ? VoxelState::NoEcho
                                         : VoxelState::NotScanned);
    volume.values.push_back(echo ? 0.25F * static_cast<float>(i + 4) : volume.fill);
  }
  return volume;
}

/// Gives a volume of two sites ancillary arrays, in which no two voxels in a row are alike: a voxel
/// in three is not scanned, as MakeGriddedVolume has them.
inline void AddAncillary(GriddedVolume& volume)
{
  for (std::size_t i = 0; i < volume.grid.VoxelCount(); ++i)
  {
    const bool scanned = volume.states[i] != VoxelState::NotScanned;
    const auto number = static_cast<float>(i);
    volume.ancillary.age.push_back(scanned ? 0.123F + 7.77F * number : 0.0F);
    volume.ancillary.radars.push_back(static_cast<std::uint8_t>(scanned ? 1 + i % 2 : 0));
    volume.ancillary.weight.push_back(scanned ? 1.0F / (1.0F + number) : 0.0F);
    volume.ancillary.nearestSite.push_back(
      static_cast<std::uint8_t>(scanned ? i % 2 : AncillaryArrays::NoSite));
  }
}

} // namespace nexrad::testing
