// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Geometry/Beam.h"

#include <optional>
#include <vector>

namespace nexrad
{

struct BeamSweep;

/// The reflectivity that the tilt beside an echo has over the same place.
struct NeighbourEcho
{
  bool measured = false;      ///< it saw an echo or no echo
  std::optional<float> value; ///< dBZ; empty: no echo
  float gap = 0.0F;           ///< degrees between the two tilts
};

/// Deconvolves the reflectivity of one tilt in elevation (Formulas G9): the value, dBZ, in the
/// middle of a beam of `beamWidth` degrees whose mean of Z is `value`, dBZ above 0. The slopes
/// to the neighbouring tilts say how the echo changes within the beam.
float SharpenValue(
  float value, const NeighbourEcho& below, const NeighbourEcho& above, float beamWidth);

/// Deconvolves all echo above 0 dBZ in the sweeps of one volume of reflectivity. The neighbouring
/// tilts are the nearest below and above that are more than SameTilt away; of repeated cuts the
/// one scanned nearest in time. States stay, so that an echo may come out below 0 dBZ. A sweep that
/// has a neighbour gets a scale that leaves room for the changes (SharpeningRange).
void SharpenSweeps(std::vector<BeamSweep>& sweeps, double beamWidth, const BeamModel& beam);

/// How far a value can change, dB: downwards and upwards.
struct SharpeningRange
{
  static constexpr float Down = 12.0F;
  static constexpr float Up = 3.0F;
};

} // namespace nexrad
