// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Model/VolumeCuts.h"

#include <cstdint>
#include <vector>

namespace nexrad
{

/// Numbers of the coverage patterns that the simulator can scan (11, 12, 21, 31, 32, 35, 121, 212,
/// 215), ascending.
std::vector<int> KnownCoveragePatterns();

/// A cut as the simulator scans it.
struct ScanCut
{
  CoverageCut cut;
  double unambiguousRange = 466.0; ///< km, of the pulses that measure velocity (reflectivity, in a
                                   ///< surveillance cut)
};

/// The cuts of a coverage pattern; nullptr for a pattern that the simulator does not know. Angles,
/// waveforms and azimuth rates are those of message 5 of real files, unambiguous ranges those of
/// their rays.
const std::vector<ScanCut>* FindScanStrategy(int pattern);

/// Gates of one moment along a ray.
struct GateLayout
{
  int gates = 0;
  int firstGate = 0;   ///< m, centre
  int gateSpacing = 0; ///< m

  double Range(int gate) const { return firstGate + static_cast<double>(gateSpacing) * gate; }
};

/// Which moments a cut has, and where their gates lie, as in real files of message 1 (1 km and
/// 250 m) or of message 31 (250 m).
struct CutLayout
{
  GateLayout echo;         ///< as far as the radar can see an echo in this cut, folded ones too
  GateLayout reflectivity; ///< no gates: the cut has no REF
  GateLayout doppler;      ///< of VEL and SW; no gates: the cut has neither
  int rays = 0;
  double raySpacing = 1.0; ///< degrees
};
CutLayout LayOut(const ScanCut& cut, bool superResolution);

/// Nyquist velocity of an S-band radar whose pulses are `unambiguousRange` km apart, m/s.
double NyquistVelocity(double unambiguousRange);

/// A velocity as a radar measures it, between −nyquist and nyquist (both in m/s, nyquist above 0):
/// v − 2·n·nyquist with n whole.
double FoldVelocity(double velocity, double nyquist);

} // namespace nexrad
