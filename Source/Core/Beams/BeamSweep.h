// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Geometry/Beam.h"
#include "nexrad/Model/Time.h"
#include "nexrad/Polar/GateCode.h"
#include "nexrad/Polar/GateRows.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

namespace nexrad
{

/// How much of what lies in a cell or about a point is of each kind.
struct StateWeights
{
  float echo = 0.0F;
  float none = 0.0F;
  float folded = 0.0F;
  float filtered = 0.0F;
  float missing = 0.0F;

  /// Adds a gate of a code below GateCode::FirstValue.
  void AddNothing(std::uint16_t code, float weight)
  {
    float& of = code == GateCode::NoEcho        ? none
                : code == GateCode::RangeFolded ? folded
                : code == GateCode::Filtered    ? filtered
                                                : missing;
    of += weight;
  }
  /// Where nothing was measured, the code of the state of most of it.
  std::uint16_t CodeOfNothing() const
  {
    if (filtered > folded)
    {
      return filtered >= missing ? GateCode::Filtered : GateCode::NotSampled;
    }
    return folded >= missing ? GateCode::RangeFolded : GateCode::NotSampled;
  }
};

/// A sweep reduced to the resolution of a grid whose voxels are coarser than its gates: means over
/// cells of about equal area (Formulas G10). Rings of one width along the range; a ring is divided
/// into sectors where voxels are coarser than the rays' spacing too, and into the rays of the sweep
/// elsewhere. Interpolated bilinearly, the cells smooth as much as a mean over the voxel.
struct SweepMeans
{
  /// The mean over one cell: the value of the number (GateScale) over its echo, which fills
  /// echo/255 of it; missing/255 of it was not measured, and the rest is no echo. A cell of which
  /// nothing was measured has, in place of the number, the code of the state that most of it has.
  struct Cell
  {
    std::uint16_t code = 0; ///< the number, or the code of a state
    std::uint8_t echo = 0;
    std::uint8_t missing = 0;

    /// All of it in one number, which is 0 for a cell of no echo alone.
    std::uint32_t Word() const
    {
      return code | static_cast<std::uint32_t>(echo) << 16U |
             static_cast<std::uint32_t>(missing) << 24U;
    }
  };

  struct Ring
  {
    std::uint32_t first = 0; ///< place of its first cell
    int sectors = 0;         ///< 0: its cells are the entries of the sweep
    float sectorsPerDegree = 0.0F;
  };

  float reach = -std::numeric_limits<float>::infinity(); ///< m, slant range below which the means
                                                         ///< serve, and from which gates do
  float firstRing = 0.0F;     ///< m, slant range of the first ring's middle
  float ringsPerMetre = 0.0F; ///< 1 / width of the rings
  GateScale scale;            ///< of the numbers; finer than that of the gates
  float spread = 0.0F;     ///< m along the ground: a gate farther from a column, but for its length
                           ///< and its ray's width, does not count in the column's sample
  std::vector<Ring> rings; ///< outwards
  std::vector<Cell> cells; ///< of a ring of n sectors n + 2: the last, all, the first again

  std::size_t MemoryBytes() const
  {
    return rings.size() * sizeof(Ring) + cells.size() * sizeof(Cell);
  }
};

/// One sweep as the merge by beams looks gates up: rays by azimuth, and the code of each gate in 16
/// bits. Behind the last gate of all rays that holds anything but no echo none are stored: most
/// tilts leave the echo long before their rays end.
///
/// Rays stand in the order of their azimuths, with the last one repeated before the first (less
/// 360°) and the first after the last (plus 360°), so that each direction lies between an entry and
/// the next.
struct BeamSweep
{
  static constexpr float BinsPerDegree = 2.0F;

  float elevation = 0.0F;     ///< degrees, median of the rays (Formulas Q7)
  float sine = 0.0F;          ///< of the elevation
  float cosine = 1.0F;        ///< of the elevation
  float firstGate = 0.0F;     ///< m, slant range of the first gate's centre
  float gatesPerMetre = 0.0F; ///< 1 / spacing of the gates
  int gates = 0;              ///< of each ray
  int storedGates = 0;        ///< of each ray; those behind them hold no echo
  GateScale scale;            ///< of the codes
  bool strays = false;        ///< rays that stray from the cut were left out
  bool complete = false;      ///< the rays leave no gap, and all of their gates were sampled
  Time begin{};               ///< earliest ray
  Time end{};                 ///< latest ray

  std::vector<float> azimuths;    ///< of the entries, degrees, ascending
  std::vector<float> elevations;  ///< of the entries, degrees
  std::vector<float> inverseGaps; ///< 1 / degrees from an entry to the next; 0 where the gap is too
                                  ///< wide to interpolate across, and for the last
  std::vector<float> times;       ///< of the entries, s since `begin`
  std::vector<std::uint32_t> firstEntries;      ///< last entry at or before the start of each bin
  std::shared_ptr<const std::uint16_t[]> codes; ///< CodeCount(): of each entry the stored gates,
                                                ///< and the gate behind them or the last again;
                                                ///< shared by copies of the sweep
  std::vector<GateRange> held; ///< of the entries: from the first to the last gate that holds
                               ///< anything but no echo
  float halfWidth = 0.0F;      ///< degrees that a ray is wide to either side at the edge of a gap
  SweepMeans means;            ///< of the gates, for voxels coarser than these; may be empty

  /// True when the rays leave no gap too wide to interpolate across.
  bool IsClosed() const
  {
    return std::all_of(
      inverseGaps.begin(), inverseGaps.end() - 1, [](float gap) { return gap > 0.0F; });
  }
  /// The entry at or before an azimuth, 0 ≤ azimuth < 360 degrees.
  std::size_t EntryBefore(float azimuth) const
  {
    std::size_t entry = firstEntries[static_cast<std::size_t>(azimuth * BinsPerDegree)];
    while (azimuths[entry + 1] <= azimuth)
    {
      ++entry;
    }
    return entry;
  }
  std::size_t Stride() const { return static_cast<std::size_t>(storedGates) + 1; }
  std::size_t CodeCount() const { return azimuths.size() * this->Stride(); }
  /// The codes of the stored gates of an entry.
  const std::uint16_t* Row(std::size_t entry) const { return codes.get() + entry * this->Stride(); }
  /// The code of any gate of an entry.
  std::uint16_t CodeAt(std::size_t entry, int gate) const
  {
    return gate < storedGates ? this->Row(entry)[gate] : GateCode::NoEcho;
  }
  /// Outer edge of the last gate, m.
  float Reach() const { return firstGate + (static_cast<float>(gates) - 0.5F) / gatesPerMetre; }
};

/// The entry of a sweep nearest to an azimuth, 0 ≤ azimuth < 360 degrees; −1 where it has no ray
/// there.
int NearestEntry(const BeamSweep& sweep, float azimuth);

/// The least and the largest code of a value in a sweep.
struct CodeRange
{
  std::uint16_t least = GateCode::Last;
  std::uint16_t most = 0;

  bool IsEmpty() const { return most < GateCode::FirstValue; }
};
CodeRange FindValueCodes(const BeamSweep& sweep);

/// Slant range of the middle of a gate, m.
double RangeOf(const BeamSweep& sweep, int gate);

/// Slant range, m, at which a sweep stands over a ground distance, m.
double RangeOver(const BeamSweep& sweep, double groundDistance, const BeamModel& beam);

/// For each gate of `other`, the gate of `sweep` over the same place; −1 where it has none.
std::vector<int> GatesOver(const BeamSweep& sweep, const BeamSweep& other, const BeamModel& beam);

} // namespace nexrad
