// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Polar/PolarVolume.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace nexrad
{

/// In place of a number where a gate has none: it differs from every value by more than any
/// threshold does.
constexpr float NoNumber = -1000.0F;

/// Whether a gate has a number.
inline bool IsNumber(float value)
{
  return value > 0.5F * NoNumber;
}

/// Degrees between two rays that are neighbours, at most.
constexpr double WidestGap = 1.9;

/// The rays of a sweep, in the order of their azimuths.
class SweepRays
{
public:
  explicit SweepRays(const PolarSweep& sweep);

  std::size_t Rays() const { return order.size(); }
  /// Degrees, the median of the rays.
  double Elevation() const { return elevation; }
  /// The ray of the sweep at a place, and its azimuth in degrees, 0…360.
  std::size_t RayAt(std::size_t place) const { return order[place]; }
  double AzimuthAt(std::size_t place) const { return azimuths[place]; }
  /// The place nearest to an azimuth; Rays() where none is within `farthest` degrees. There must be
  /// rays.
  std::size_t PlaceAt(double azimuth, double farthest = 1.5) const;
  /// The place after (`step` above 0) or before another, round the circle; Rays() across a gap of
  /// more than WidestGap between two rays on the way.
  std::size_t Beside(std::size_t place, int step) const;

private:
  double elevation;
  std::vector<std::size_t> order;
  std::vector<double> azimuths;
  std::vector<std::uint8_t> linked; // whether the ray after each is its neighbour
};

/// Reflectivity of one sweep in dBZ, a row for each ray, in the order of azimuths. Of each row only
/// the gates from the first to behind the last that holds anything but no echo are held: most gates
/// hold none. Other arrays of numbers by gate have the same places (Index).
class EchoGrid : public SweepRays
{
public:
  /// Reads a sweep, which must have rays and gates.
  explicit EchoGrid(const PolarSweep& sweep);

  std::size_t Gates() const { return gates; }
  double GateSpacing() const { return spacing; }
  /// Slant range of a gate's centre, m.
  double RangeOf(std::size_t gate) const { return first + spacing * static_cast<double>(gate); }
  /// The gate nearest to a slant range in m; it need not exist.
  std::ptrdiff_t GateAt(double range) const;
  /// Gates of every ray whose centre lies within a slant range, m.
  std::size_t GatesWithin(double range) const;

  /// The gates of a row that are held; none of Rays(), which stands for a row that is not there.
  GateRange Held(std::size_t place) const { return held[place]; }
  /// Where the number of a gate that is held stands, in this grid and in arrays of Count() others.
  std::size_t Index(std::size_t place, std::size_t gate) const { return starts[place] + gate; }
  /// Numbers that such an array has.
  std::size_t Count() const { return starts.back(); }

  /// `Row(place)[gate]` is the value of a gate that is held; NoNumber where it has none.
  const float* Row(std::size_t place) const { return values.get() + starts[place]; }
  /// The value of any gate; NoNumber where it has none.
  float At(std::size_t place, std::size_t gate) const
  {
    return held[place].Holds(gate) ? this->Row(place)[gate] : NoNumber;
  }
  /// Reads the values of any gates that follow each other.
  void Read(std::size_t place, const GateRange& range, float* to) const;

private:
  double first;
  double spacing;
  std::size_t gates;
  std::vector<GateRange> held;
  std::vector<std::size_t> starts; // where gate 0 of each row would stand
  std::unique_ptr<float[]> values; // behind room, so that no row starts before the first
};

/// Gates of one row that follow each other, from `begin` up to `end`, and the region they are of.
struct GateRun
{
  std::uint32_t place = 0; ///< the row, as EchoGrid counts them
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
  std::uint32_t region = 0;
};

/// The connected regions of some gates of a sweep. Gates are connected along the ray, and with the
/// three nearest ones of the neighbouring rays.
class GateRegions
{
public:
  /// `members`: by EchoGrid::Index, other than 0 for the gates that count.
  GateRegions(const EchoGrid& grid, const std::vector<std::uint8_t>& members);

  const std::vector<GateRun>& Runs() const { return runs; }
  std::size_t Count() const { return count; }

private:
  std::uint32_t RootOf(std::uint32_t run);
  void Join(std::size_t first, std::size_t second, const std::vector<std::size_t>& firstRuns);

  std::vector<GateRun> runs;
  std::vector<std::uint32_t> parents;
  std::size_t count = 0;
};

} // namespace nexrad
