// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Grid/GriddedVolume.h"
#include "nexrad/System/RangeLoop.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace nexrad
{

/// Calls `visit(i)` for each of the `count` voxels that is an echo, in ascending order. Few voxels
/// hold an echo; the library looks for the next one many at a time.
template <class Visit>
void ForEachEcho(const VoxelState* states, std::size_t count, const Visit& visit)
{
  const auto nextEcho = [states, count](std::size_t from)
  {
    const void* found =
      std::memchr(states + from, static_cast<int>(VoxelState::Echo), count - from);
    return found ? static_cast<std::size_t>(static_cast<const VoxelState*>(found) - states) : count;
  };
  for (std::size_t i = nextEcho(0); i < count; i = nextEcho(i))
  {
    for (; i < count && states[i] == VoxelState::Echo; ++i)
    {
      visit(i);
    }
  }
}

/// Codes of 8 or 16 bits for the voxels of a volume: 0 no echo, 1 not scanned, from 2 on an echo of
/// offset + scale × code. The steps are those of the words of message 31 (ICD 2620002, table
/// XVII-I), so that a merged value is off by at most half of what the radar tells apart. Range
/// folded has no code of its own and becomes 0.
struct MomentCode
{
  static constexpr unsigned NoEchoCode = 0;
  static constexpr unsigned NotScannedCode = 1;
  static constexpr unsigned FirstEchoCode = 2;

  unsigned bytes = 1;    ///< of a code, 1 or 2
  double offset = -33.0; ///< unit of the moment
  double scale = 0.5;    ///< unit of the moment a code, above 0

  /// The code for a volume's moment: REF −32…94.5 dBZ, VEL −63.5…63 m/s in 8 bits (in 16 when an
  /// echo is faster, as radars with steps of 1 m/s have them), SW to 63 m/s, ZDR from −13 dB in 16
  /// bits, PHI in 16 bits, RHO 0.2083…1.0517, CFP to 247 dB; SRV as VEL, AZSHEAR and DIV
  /// ±0.3277/s by 0.00001/s, KDP ±327.67 degrees/km by 0.01, these in 16 bits.
  static MomentCode Of(const GriddedVolume& volume);

  /// The same where the voxels are not known: velocities in 16 bits.
  static MomentCode Widest(MomentName moment);

  /// The code of an echo. What lies beyond the first or last code gets that: an echo stays an echo.
  /// A value that is not a number counts as not scanned.
  unsigned Encode(float value) const;
  /// The state that a code stands for.
  static VoxelState StateOf(unsigned code);
  /// The value of an echo's code.
  float ValueOf(unsigned code) const { return static_cast<float>(offset + scale * code); }

  /// Writes a byte of the code of each of `count` voxels: the lower one (`shift` 0), or the higher
  /// one (`shift` 8).
  void WriteBytes(const float* values, const VoxelState* states, std::size_t count, unsigned shift,
    std::uint8_t* to) const;
  /// Writes the bytes [first, first + count) of the codes of all voxels to `to`: these are a byte
  /// each, or the lower bytes of all and then the higher bytes of all.
  void WriteBytes(
    const GriddedVolume& volume, std::size_t first, std::size_t count, std::uint8_t* to) const;
  /// Sets values and states of a volume from all bytes of their codes; voxels without echo get the
  /// volume's fill.
  void DecodeAll(const std::vector<std::uint8_t>& codes, GriddedVolume& volume) const;
};

/// What codes of one byte stand for.
struct VoxelCodes
{
  static constexpr std::size_t Count = 256;

  std::array<float, Count> values{}; ///< moment's unit; the volume's fill where it is no echo
  std::array<VoxelState, Count> states{};
};

/// Sets the values and states of `count` voxels from their codes.
void ExpandCodes(const VoxelCodes& meaning, const std::uint8_t* codes, std::size_t count,
  float* values, VoxelState* states, const RangeLoop& loop = {});

/// Throws Error unless the volume has one value and one state, or a code, for each voxel of its
/// grid.
void CheckVoxelCount(const GriddedVolume& volume);

} // namespace nexrad
