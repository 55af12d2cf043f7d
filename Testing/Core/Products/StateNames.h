// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Grid/GriddedVolume.h"

namespace nexrad::testing
{

// Short, as volumes are written out by hand.
constexpr VoxelState echo = VoxelState::Echo;
constexpr VoxelState none = VoxelState::NoEcho;
constexpr VoxelState folded = VoxelState::RangeFolded;
constexpr VoxelState open = VoxelState::NotScanned;

} // namespace nexrad::testing
