// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace nexrad
{

/// What is true of the gates of one simulated ray.
struct RayTruth
{
  /// Of each gate of VEL: the radial velocity before noise and folding, m/s, positive away from the
  /// radar. NaN where the word is no velocity (no echo, range folded), empty without VEL.
  std::vector<float> velocity;
};

/// What is true of the gates of a simulated volume: `sweeps[s][r]` is about the ray
/// `sweeps[s].rays[r]` of the RadarVolume.
struct ScanTruth
{
  std::vector<std::vector<RayTruth>> sweeps;
};

} // namespace nexrad
