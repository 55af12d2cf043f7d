// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Polar/PolarVolume.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace nexrad
{

/// Direction and Nyquist velocity of one ray.
struct VelocityRay
{
  float azimuth = 0.0F;   ///< degrees clockwise from north
  float elevation = 0.0F; ///< degrees
  float nyquist = 0.0F;   ///< m/s; 0 when unknown
};

/// Where the gates of a sweep are.
struct RangeGates
{
  double elevation = 0.0;   ///< degrees, the median of the rays'
  double firstGate = 0.0;   ///< m, slant range of the first gate's centre; may be negative
  double gateSpacing = 0.0; ///< m
  std::size_t gates = 0;    ///< of each ray

  /// Slant range of a gate's centre, m.
  double RangeOf(std::size_t gate) const
  {
    return firstGate + gateSpacing * static_cast<double>(gate);
  }
};

/// Radial velocities of one sweep, rays × gates, gates fastest. They are numbers and not the words
/// of the file, because an unfolded velocity lies outside of what the words can hold.
struct VelocitySweep : RangeGates
{
  std::vector<VelocityRay> rays;
  std::vector<float> values; ///< m/s, away from the radar positive; NaN unless the state is Valid
  std::vector<GateState> states; ///< NotSampled also where a measured velocity has no known fold

  std::size_t Index(std::size_t ray, std::size_t gate) const { return ray * gates + gate; }
};

/// The radial velocities of one volume of one site.
struct VelocityVolume
{
  std::vector<VelocitySweep> sweeps; ///< those that have velocities, in the order scanned
};

/// The velocities of polar data of VEL as they are: folded, each within the Nyquist velocity of its
/// ray. A VelocitySweep for each PolarSweep, with the same rays and gates.
VelocityVolume MakeVelocityVolume(const PolarVolume& volume);

/// Folds of gates or regions: the whole number n of Formulas V1.
using Fold = std::int8_t;
constexpr Fold NoFold = std::numeric_limits<Fold>::min(); ///< not known
constexpr int MostFolds = 3; ///< folds lie in −3…3: no wind goes beyond seven Nyquist velocities

/// The folded velocities of a sweep in the order of azimuths, so that rows beside each other are
/// rays beside each other; the last row is beside the first.
struct SweepRing : RangeGates
{
  std::size_t rows = 0;
  std::vector<std::size_t> ray;     ///< of each row: its ray in the sweep
  std::vector<float> azimuth;       ///< of each row, degrees, 0…360, ascending
  std::vector<float> nyquist;       ///< of each row, m/s; 0 when unknown
  std::vector<std::uint8_t> beside; ///< of each row: 1 when no ray is missing before the next row
  std::vector<float> velocity; ///< m/s, rows × gates; NaN without a value or a Nyquist velocity
  std::vector<std::size_t> rowOfBin; ///< nearest to each half degree of azimuth; NoRow in a gap

  bool HasValue(std::size_t index) const { return !std::isnan(velocity[index]); }
  std::size_t NextRow(std::size_t row) const { return row + 1 == rows ? 0 : row + 1; }
  std::size_t PreviousRow(std::size_t row) const { return row == 0 ? rows - 1 : row - 1; }
  /// Whether two rows fold alike: a fold of one means as many m/s as a fold of the other.
  bool FoldAlike(std::size_t a, std::size_t b) const
  {
    return std::abs(nyquist[a] - nyquist[b]) < 0.05F;
  }
  static constexpr std::size_t NoRow = std::numeric_limits<std::size_t>::max();
  /// The row nearest to an azimuth, 0…360 degrees, to half a degree; NoRow where there is a gap.
  std::size_t RowAt(float azimuth) const;
};

SweepRing MakeSweepRing(const VelocitySweep& sweep);

/// A difference of two folded velocities, brought into −nyquist…nyquist. `difference` in
/// −3·nyquist…3·nyquist, both m/s.
inline float FoldDifference(float difference, float nyquist)
{
  return difference > nyquist    ? difference - 2.0F * nyquist
         : difference < -nyquist ? difference + 2.0F * nyquist
                                 : difference;
}

} // namespace nexrad
