// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Beams/BeamSharpening.h"

#include "nexrad/Beams/BeamSweep.h"
#include "nexrad/Model/Elevation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace nexrad
{

namespace
{

// How far a value can change, dB.
constexpr float mostDown = 12.0F;
constexpr float mostUp = 3.0F;

// Beyond, the pattern is no Gaussian any more: an echo is not taken to come from farther off the
// beam's middle than two standard deviations.
constexpr float steepestRise = 2.0F;
constexpr float steepestFall = -6.0F; // the mean hardly changes any more

// What one side of the beam adds to the mean of Z, in parts of the Z in its middle, by the slope on
// that side, in e-folds of Z a standard deviation of the pattern: exp(s²/2)·Φ(s), half where flat.
class SideTable
{
public:
  SideTable()
  {
    for (std::size_t i = 0; i < sides.size(); ++i)
    {
      const double slope = static_cast<double>(steepestFall) + static_cast<double>(i) / perUnit;
      sides[i] = static_cast<float>(
        std::exp(0.5 * slope * slope) * 0.5 * std::erfc(-slope / std::sqrt(2.0)));
    }
  }

  float At(float slope) const
  {
    const float place =
      (std::clamp(slope, steepestFall, steepestRise) - steepestFall) * static_cast<float>(perUnit);
    const auto before = std::min(static_cast<std::size_t>(place), sides.size() - 2);
    return sides[before] +
           (place - static_cast<float>(before)) * (sides[before + 1] - sides[before]);
  }

private:
  static constexpr int perUnit = 32;
  static constexpr int units = 8; // from the steepest fall to the steepest rise
  std::array<float, units * perUnit + 1> sides{};
};
const SideTable sideTable;

// What one side of a beam is known to hold: the slope of the echo there, 0 where nothing was
// measured.
struct BeamSide
{
  bool measured = false;
  float slope = 0.0F;
};

float SharpenBetween(float value, const BeamSide& below, const BeamSide& above)
{
  if (below.slope == 0.0F && above.slope == 0.0F)
  {
    return value;
  }
  // What the beam's other half holds must be known before an echo is said not to fill the beam; and
  // an echo between two weaker ones is taken to fill half the beam, not less: it may be clutter.
  const float gain = below.measured && above.measured ? mostUp : 0.0F;
  constexpr float decibelsPerDoubling = 3.01029996F;
  const float excess =
    decibelsPerDoubling * std::log2(sideTable.At(below.slope) + sideTable.At(above.slope));
  return value - std::max(excess, -gain);
}

// What is left of a cut when another one serves most of its directions.
bool IsRemnant(const BeamSweep& other, const BeamSweep& sweep)
{
  return 5 * other.azimuths.size() < 2 * sweep.azimuths.size(); // half as many may be wider rays
}

// Of the sweeps on one side the nearest tilt, and of its cuts the one nearest in time.
const BeamSweep* FindBeside(
  const std::vector<BeamSweep>& sweeps, const BeamSweep& sweep, float side)
{
  constexpr auto same = static_cast<float>(SameTilt);
  const BeamSweep* found = nullptr;
  float nearest = 0.0F;
  for (const BeamSweep& other : sweeps)
  {
    const float away = side * (other.elevation - sweep.elevation);
    const bool nearer = found == nullptr || away < nearest - same;
    const auto apart = [&sweep](const BeamSweep& each)
    { return std::abs((each.begin - sweep.begin).count()); };
    if (away > same && !IsRemnant(other, sweep) &&
        (nearer || (away < nearest + same && apart(other) < apart(*found))))
    {
      nearest = nearer ? away : nearest;
      found = &other;
    }
  }
  return found;
}

// What a sweep beside has at the places of another's gates: slopes towards it, in e-folds of Z a
// standard deviation of the two-way pattern, which is 0.285 of a beam width of 0.95°. Differences
// over less than that are noise more than slope. Towards a tilt without echo the echo ends half a
// beam width before it, but not before the middle (Formulas G8).
class NeighbourSweep
{
public:
  NeighbourSweep(
    const BeamSweep* beside, const BeamSweep& of, float beamWidth, const BeamModel& beam)
    : sweep(beside)
  {
    if (sweep != nullptr)
    {
      const float gap = std::abs(sweep->elevation - of.elevation);
      perDecibel = naturalPerDecibel * std::min(perBeamWidth * beamWidth / gap, 1.0F);
      perDecibelToNone = perDecibel / std::max(0.5F, 1.0F - 0.5F * beamWidth / gap);
      gates = GatesOver(*sweep, of, beam);
    }
  }

  bool IsThere() const { return sweep != nullptr; }

  void TurnTo(float azimuth) { entry = sweep != nullptr ? NearestEntry(*sweep, azimuth) : -1; }

  // The side of the beam towards this sweep, of an echo of `value` dBZ.
  BeamSide At(std::size_t gate, float value) const
  {
    if (entry < 0 || gates[gate] < 0)
    {
      return {};
    }
    const std::uint16_t code = sweep->CodeAt(static_cast<std::size_t>(entry), gates[gate]);
    if (code >= GateCode::FirstValue)
    {
      return {true, perDecibel * (sweep->scale.ValueOf(code) - value)};
    }
    return code == GateCode::NoEcho ? BeamSide{true, -perDecibelToNone * value} : BeamSide{};
  }

private:
  static constexpr float perBeamWidth = 0.30028060F;      // 1/√(16 ln 2)
  static constexpr float naturalPerDecibel = 0.23025851F; // ln(10)/10
  const BeamSweep* sweep;
  float perDecibel = 0.0F;
  float perDecibelToNone = 0.0F;
  std::vector<int> gates; // by gate of the other sweep
  int entry = -1;         // of the ray that it is turned to; -1 without one
};

// Deconvolves the echo of a sweep above 0 dBZ. The values are rounded here: to a scale of their
// own.
class SweepSharpener
{
public:
  SweepSharpener(const BeamSweep& theSweep, const std::vector<BeamSweep>& sweeps, float beamWidth,
    const BeamModel& beam)
    : sweep(theSweep)
    , below(FindBeside(sweeps, sweep, -1.0F), sweep, beamWidth, beam)
    , above(FindBeside(sweeps, sweep, 1.0F), sweep, beamWidth, beam)
  {
  }

  BeamSweep Sharpen()
  {
    BeamSweep sharpened = sweep;
    const CodeRange values = FindValueCodes(sweep);
    if (values.IsEmpty() || !(below.IsThere() || above.IsThere()))
    {
      return sharpened;
    }
    sharpened.scale = GateScale::Between(
      sweep.scale.ValueOf(values.least) - mostDown, sweep.scale.ValueOf(values.most) + mostUp);
    const std::shared_ptr<std::uint16_t[]> codes(new std::uint16_t[sweep.CodeCount()]);
    for (std::size_t entry = 0; entry < sweep.azimuths.size(); ++entry)
    {
      this->SharpenRay(entry, sharpened.scale, codes.get() + entry * sweep.Stride());
    }
    sharpened.codes = codes;
    return sharpened;
  }

private:
  void SharpenRay(std::size_t entry, const GateScale& scale, std::uint16_t* to)
  {
    const GateRange& held = sweep.held[entry];
    std::fill(to, to + held.begin, GateCode::NoEcho);
    std::fill(to + held.end, to + sweep.Stride(), GateCode::NoEcho);
    if (held.IsEmpty())
    {
      return;
    }
    const float azimuth = sweep.azimuths[entry];
    const float turned = azimuth < 0.0F     ? azimuth + 360.0F
                         : azimuth < 360.0F ? azimuth
                                            : azimuth - 360.0F;
    below.TurnTo(turned);
    above.TurnTo(turned);
    const std::uint16_t* codes = sweep.Row(entry);
    for (std::size_t gate = held.begin; gate < held.end; ++gate)
    {
      to[gate] = codes[gate];
      if (codes[gate] >= GateCode::FirstValue)
      {
        const float value = sweep.scale.ValueOf(codes[gate]);
        to[gate] = scale.CodeOf(
          value > 0.0F ? SharpenBetween(value, below.At(gate, value), above.At(gate, value))
                       : value);
      }
    }
    if (sweep.storedGates == sweep.gates)
    {
      to[sweep.gates] = to[sweep.gates - 1];
    }
  }

  const BeamSweep& sweep;
  NeighbourSweep below;
  NeighbourSweep above;
};

} // namespace

void SharpenSweeps(std::vector<BeamSweep>& sweeps, double beamWidth, const BeamModel& beam)
{
  std::vector<BeamSweep> sharpened;
  for (const BeamSweep& sweep : sweeps)
  {
    sharpened.push_back(
      SweepSharpener(sweep, sweeps, static_cast<float>(beamWidth), beam).Sharpen());
  }
  sweeps = std::move(sharpened);
}

} // namespace nexrad
