// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Grid/GriddedVolume.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace nexrad
{

/// How far a gridded volume is from the truth. All of it is over the voxels that count, and a
/// result without echo (no echo, range folded, not scanned) has the value 0 dBZ, as has a truth
/// below 0 dBZ: nobody is charged for the depth of nothing.
struct TruthScore
{
  static constexpr float EchoThreshold = 10.0F; ///< dBZ, from which on an echo matters

  std::size_t voxels = 0;    ///< voxels that count
  std::size_t compared = 0;  ///< of them, those where truth or result is at least the threshold
  std::size_t trueEcho = 0;  ///< of them, those where the truth is
  std::size_t missed = 0;    ///< truth at least the threshold, result 0 dBZ
  std::size_t falseEcho = 0; ///< result at least the threshold, truth 0 dBZ
  double rmse = 0.0; ///< dBZ, root mean square of result − truth over `compared`; 0 for none
  double bias = 0.0; ///< dBZ, mean of result − truth over `compared`; 0 for none

  /// `missed` and `falseEcho` as parts of `trueEcho`; 0 when there is no true echo.
  double MissedFraction() const;
  double FalseFraction() const;
};

/// Compares a volume with the truth at its voxels (`truth` in dBZ, −infinity allowed, in the order
/// of the volume's values) where `counts` is not 0 (BeamCoverage). Throws Error when the sizes
/// differ.
TruthScore CompareWithTruth(const GriddedVolume& result, const std::vector<float>& truth,
  const std::vector<std::uint8_t>& counts);

} // namespace nexrad
