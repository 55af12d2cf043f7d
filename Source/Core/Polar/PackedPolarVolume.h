// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Polar/PolarVolume.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace nexrad
{

/// A polar volume in little memory, to be had back exactly: radars send few different values, and
/// most gates hold none. A tenth of the bytes is usual. A sweep of too many values for codes of a
/// byte is kept as it is.
class PackedPolarVolume
{
public:
  explicit PackedPolarVolume(const PolarVolume& volume);

  PolarVolume Unpack() const;
  /// Memory that this takes.
  std::size_t Bytes() const;

private:
  struct PackedSweep
  {
    bool packed = false;
    std::vector<float> table;        ///< the values that occur
    std::vector<std::uint8_t> bytes; ///< codes in runs and literals
  };

  PolarVolume frame; ///< without the values and states of packed sweeps
  std::vector<PackedSweep> sweeps;
};

/// Bytes that a volume takes in memory.
std::size_t MemoryOf(const PolarVolume& volume);

} // namespace nexrad
