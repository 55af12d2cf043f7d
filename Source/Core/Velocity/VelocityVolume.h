// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Model/RadarVolume.h"
#include "nexrad/Polar/PolarVolume.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace nexrad
{

/// What a gate of a velocity sweep holds. The first four are those of GateState.
enum class VelocityState : std::uint8_t
{
  Valid = 0,
  BelowThreshold = 1, ///< scanned, and no echo above the noise
  RangeFolded = 2,    ///< an echo whose range is ambiguous
  NotSampled = 3,     ///< the ray does not reach the gate, or no measurement can give its word
  Unknown = 4         ///< a velocity was measured, and no rule tells its fold (Formulas V4)
};

/// Direction, time and Nyquist velocity of one ray.
struct VelocityRay
{
  float azimuth = 0.0F;   ///< degrees clockwise from north
  float elevation = 0.0F; ///< degrees
  float nyquist = 0.0F;   ///< m/s; 0 when unknown
  Time time{};
};

/// Radial velocities of one sweep, rays × gates, gates fastest. They are numbers and not the words
/// of the file, because an unfolded velocity lies outside of what the words can hold.
struct VelocitySweep
{
  int elevationNumber = 0;  ///< number of the cut in the coverage pattern, from 1
  double elevation = 0.0;   ///< degrees, the median of the rays'
  double firstGate = 0.0;   ///< m, slant range of the first gate's centre; may be negative
  double gateSpacing = 0.0; ///< m
  std::size_t gates = 0;    ///< of each ray
  std::vector<VelocityRay> rays;
  std::vector<float> values; ///< m/s, away from the radar positive; NaN unless the state is Valid
  std::vector<VelocityState> states;

  std::size_t Index(std::size_t ray, std::size_t gate) const { return ray * gates + gate; }
  /// Slant range of a gate's centre, m.
  double RangeOf(std::size_t gate) const
  {
    return firstGate + gateSpacing * static_cast<double>(gate);
  }
};

/// The radial velocities of one volume of one site.
struct VelocityVolume
{
  Site site;
  Time start{};                      ///< first ray, of the whole volume
  Time end{};                        ///< last ray
  bool synthetic = false;            ///< from a simulated file
  std::vector<VelocitySweep> sweeps; ///< those that have velocities, in the order scanned
};

/// The velocities of a volume as the file has them: folded, each within the Nyquist velocity of its
/// ray. Rays without velocities are left out; a sweep whose rays differ in gate geometry gives one
/// VelocitySweep for each geometry, as MakePolarVolume does, with the same rays in the same order.
/// Velocities that no measurement can give (ImpossibleGates) are NotSampled.
VelocityVolume MakeVelocityVolume(const RadarVolume& volume);

/// The same of polar data of VEL: a VelocitySweep for each PolarSweep, with the same rays and
/// gates.
VelocityVolume MakeVelocityVolume(const PolarVolume& volume);

/// Folds the velocities of a sweep into −nyquist…nyquist, m/s, as a radar of that Nyquist velocity
/// would measure them; each ray then has that Nyquist velocity. Throws Error unless it is above 0.
void FoldVelocities(VelocitySweep& sweep, float nyquist);

} // namespace nexrad
