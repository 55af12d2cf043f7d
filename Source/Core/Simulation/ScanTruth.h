// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Simulation/EchoKind.h"

#include <vector>

namespace nexrad
{

/// What is true of the gates of one simulated ray.
struct RayTruth
{
  /// Of each gate of VEL: the radial velocity before noise and folding, m/s, positive away from the
  /// radar. NaN where the word is no velocity (no echo, range folded) and where the echo has none
  /// (the sun, interference, a test pattern, speckle). Empty without VEL.
  std::vector<float> velocity;
  /// Of each gate of REF: what its echo, the strongest of several, comes from; None where the word
  /// is no value. Empty without REF.
  std::vector<EchoKind> reflectivityKinds;
  /// The same of each gate of VEL; a range-folded gate has the kind of the echo at its own range.
  std::vector<EchoKind> velocityKinds;
};

/// What is true of the gates of a simulated volume: `sweeps[s][r]` is about the ray
/// `sweeps[s].rays[r]` of the RadarVolume.
struct ScanTruth
{
  std::vector<std::vector<RayTruth>> sweeps;
};

} // namespace nexrad
