// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Model/RadarVolume.h"

#include <cstddef>
#include <vector>

namespace nexrad
{

/// Direction and time of one ray.
struct PolarRay
{
  double azimuth = 0.0;   ///< degrees clockwise from north
  double elevation = 0.0; ///< degrees
  Time time{};
  double unambiguousRange = 0.0; ///< m; 0 when unknown
};

/// One moment of one sweep as numbers: rays × gates, gates fastest. All rays share one gate
/// geometry.
struct PolarSweep
{
  int elevationNumber = 0;  ///< number of the cut in the coverage pattern, from 1
  double firstGate = 0.0;   ///< m, slant range of the first gate's centre; may be negative
  double gateSpacing = 0.0; ///< m
  std::size_t gates = 0;
  std::vector<PolarRay> rays;
  std::vector<float> values; ///< unit of the moment; NaN where the state is not Valid
  std::vector<GateState> states;
  Waveform waveform = Waveform::Unknown;

  std::size_t Index(std::size_t ray, std::size_t gate) const { return ray * gates + gate; }
};

/// What gridding needs of a radar volume: one moment of one site.
struct PolarVolume
{
  Site site;
  MomentName moment = MomentName::REF;
  Time start{};                   ///< first ray, of the whole volume
  Time end{};                     ///< last ray
  bool synthetic = false;         ///< from a simulated file
  std::vector<PolarSweep> sweeps; ///< those that have the moment, in the order scanned
};

/// Converts the words of one moment. A sweep whose rays differ in gate geometry gives one
/// PolarSweep for each geometry; shorter rays are padded with NotSampled, rays without the moment
/// are left out. Of REF, LimitReach is applied to each sweep.
PolarVolume MakePolarVolume(const RadarVolume& volume, MomentName moment);

/// Of a sweep of reflectivity, takes what lies beyond the unambiguous range of its ray for not
/// scanned: a gate there that is below threshold becomes NotSampled. The pulses cannot tell that
/// nothing is there: its echo comes back after the next pulse. A gate with a value stays, since the
/// radar has moved it there from where it came back, and so does a folded one. Gates at the end of
/// the rays that are NotSampled on all of them are cut off. Sweeps of batch cuts (whose
/// reflectivity is that of long pulses, of a range that rays do not tell) and of unknown waveform
/// stay as they are, and so do rays without a range.
void LimitReach(PolarSweep& sweep);

/// The elevation of a sweep: the median of its rays', degrees; 0 without rays (Formulas Q7).
double MedianElevation(const PolarSweep& sweep);

} // namespace nexrad
