// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>

namespace nexrad
{

/// The memory that a run may take.
struct MemoryLimit
{
  std::size_t bytes = 0; ///< 0: not limited
  std::string option;    ///< that set it, as "--memory", for messages; empty: the machine has no
                         ///< more
};

/// What becomes of merged volumes, beside the one that is being made.
struct VolumeUse
{
  std::size_t others = 0;      ///< merged volumes that are there at the same time
  std::size_t bytesAVoxel = 0; ///< that are made of one volume, of all its moments together
};

} // namespace nexrad
