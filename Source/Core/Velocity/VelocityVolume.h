// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Model/RadarVolume.h"
#include "nexrad/Polar/PolarVolume.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
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

/// Folds of gates or regions: the whole number n of Formulas V1.
using Fold = std::int8_t;
constexpr Fold NoFold = std::numeric_limits<Fold>::min(); ///< not known
constexpr int MostFolds = 3; ///< folds lie in −3…3: no wind goes beyond seven Nyquist velocities

/// The folded velocities of a sweep in the order of azimuths, so that rows beside each other are
/// rays beside each other; the last row is beside the first.
struct SweepRing
{
  std::size_t rows = 0;
  std::size_t gates = 0;
  double elevation = 0.0;           ///< degrees
  double firstGate = 0.0;           ///< m
  double gateSpacing = 0.0;         ///< m
  std::vector<std::size_t> ray;     ///< of each row: its ray in the sweep
  std::vector<float> azimuth;       ///< of each row, degrees, 0…360, ascending
  std::vector<float> nyquist;       ///< of each row, m/s; 0 when unknown
  std::vector<std::uint8_t> beside; ///< of each row: 1 when no ray is missing before the next row
  std::vector<float> velocity; ///< m/s, rows × gates; NaN without a value or a Nyquist velocity

  bool HasValue(std::size_t index) const { return !std::isnan(velocity[index]); }
  std::size_t NextRow(std::size_t row) const { return row + 1 == rows ? 0 : row + 1; }
  std::size_t PreviousRow(std::size_t row) const { return row == 0 ? rows - 1 : row - 1; }
  /// Whether two rows fold alike: a fold of one means as many m/s as a fold of the other.
  bool FoldAlike(std::size_t a, std::size_t b) const
  {
    return std::abs(nyquist[a] - nyquist[b]) < 0.05F;
  }
  double RangeOf(std::size_t gate) const
  {
    return firstGate + gateSpacing * static_cast<double>(gate);
  }
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

/// Finds the row of a ring that points in a direction.
class RowFinder
{
public:
  explicit RowFinder(const SweepRing& ring);

  static constexpr std::size_t None = std::numeric_limits<std::size_t>::max();
  /// The row nearest to an azimuth, 0…360 degrees, to half a degree; None where there is a gap.
  std::size_t RowAt(float azimuth) const;

private:
  std::vector<std::size_t> rowOfBin;
};

} // namespace nexrad
