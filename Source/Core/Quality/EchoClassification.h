// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Polar/PolarVolume.h"
#include "nexrad/Quality/EchoClass.h"
#include "nexrad/System/RangeLoop.h"

#include <cstddef>
#include <vector>

namespace nexrad
{

/// What the echo of each gate of a sweep comes from, and the test that decided it. Of each ray only
/// the gates from the first to behind the last that holds anything but no echo are held.
struct SweepReasons
{
  std::size_t gates = 0;           ///< of each ray
  std::vector<GateRange> held;     ///< of each ray
  std::vector<std::size_t> starts; ///< of each ray: where gate 0 would stand in `reasons`
  std::vector<EchoReason> reasons;

  /// None for a gate that is not held. The sweep must have such a ray.
  EchoReason At(std::size_t ray, std::size_t gate) const
  {
    return held[ray].Holds(gate) ? reasons[starts[ray] + gate] : EchoReason::None;
  }
};

/// What the echo of each gate of reflectivity comes from.
struct EchoClassification
{
  std::vector<SweepReasons> sweeps; ///< those of the polar volume of REF, in their order
  ReasonCounts counts{};            ///< gates by reason, of all sweeps
};

/// Finds what the echo of each gate comes from (Formulas Q1 to Q4), from all moments that the
/// volume has. `measured` is called once each for VEL, SW, RHO, ZDR, PHI and CFP, by `loop`, which
/// runs the work; an empty one stands for as many threads as there are cores. The result does not
/// depend on it.
EchoClassification ClassifyEcho(
  const PolarVolume& reflectivity, const MeasuredVolume& measured, const RangeLoop& loop = {});

/// The same of the reflectivity of a volume as MakePolarVolume makes it.
EchoClassification ClassifyEcho(const RadarVolume& volume, const RangeLoop& loop = {});

/// Whether a level takes out the gates of a class. Off: none; Standard: ground, spikes, receiver
/// faults and speckle; Strict: biological echo, too.
bool RemovesClass(QualityLevel level, EchoClass echoClass);

/// Gates that have a value when a level has taken out its classes, of the gates by reason.
EchoGates GatesLeft(const ReasonCounts& counts, QualityLevel level);

/// Sets the gates whose class the level takes out to GateCode::Filtered. Returns how many there
/// were for each reason. `reflectivity` must be the polar volume that was classified; throws Error
/// when the number of sweeps or of gates differs.
ReasonCounts TakeOut(
  PolarVolume& reflectivity, const EchoClassification& classification, QualityLevel level);

} // namespace nexrad
