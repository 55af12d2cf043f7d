// SPDX-License-Identifier: BSD-3-Clause
#include "Gridding/BeamSharpening.h"

#include "Gridding/BeamVolume.h"
#include "Gridding/SweepPlaces.h"
#include "Model/Elevation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace nexrad
{

namespace
{

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

// In e-folds of Z a standard deviation of the two-way pattern, which is 0.285 of a beam width of
// 0.95°. Differences over less than that are noise more than slope. Towards a tilt without echo the
// echo ends half a beam width before it, but not before the middle (Formulas G8).
float SlopeTo(const NeighbourEcho& neighbour, float value, float beamWidth)
{
  constexpr float perBeamWidth = 0.30028060F;      // 1/√(16 ln 2)
  constexpr float naturalPerDecibel = 0.23025851F; // ln(10)/10
  if (!neighbour.measured)
  {
    return 0.0F;
  }
  const float spread = naturalPerDecibel * std::min(perBeamWidth * beamWidth / neighbour.gap, 1.0F);
  const float end = std::max(0.5F, 1.0F - 0.5F * beamWidth / neighbour.gap);
  return spread * (neighbour.value ? *neighbour.value - value : -value / end);
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

// What a sweep beside has at the places of another's gates.
class NeighbourSweep
{
public:
  NeighbourSweep(const BeamSweep* beside, const BeamSweep& of, const BeamModel& beam)
    : sweep(beside)
  {
    if (sweep != nullptr)
    {
      gap = std::abs(sweep->elevation - of.elevation);
      gates = GatesOver(*sweep, of, beam);
    }
  }

  void TurnTo(float azimuth) { entry = sweep != nullptr ? NearestEntry(*sweep, azimuth) : -1; }

  NeighbourEcho At(std::size_t gate) const
  {
    NeighbourEcho echo;
    if (entry < 0 || gates[gate] < 0)
    {
      return echo;
    }
    const std::uint16_t code = sweep->codes[static_cast<std::size_t>(entry) * sweep->Stride() +
                                            static_cast<std::size_t>(gates[gate])];
    echo.gap = gap;
    echo.measured = code == BeamSweep::NoEchoCode || code >= BeamSweep::FirstValueCode;
    if (code >= BeamSweep::FirstValueCode)
    {
      echo.value = sweep->base + sweep->step * static_cast<float>(code);
    }
    return echo;
  }

private:
  const BeamSweep* sweep;
  float gap = 0.0F;
  std::vector<int> gates; // by gate of the other sweep
  int entry = -1;
};

// The codes of a sweep with its echo deconvolved.
std::vector<std::uint16_t> Sharpen(const BeamSweep& sweep, const std::vector<BeamSweep>& sweeps,
  float beamWidth, const BeamModel& beam)
{
  NeighbourSweep below(FindBeside(sweeps, sweep, -1.0F), sweep, beam);
  NeighbourSweep above(FindBeside(sweeps, sweep, 1.0F), sweep, beam);
  std::vector<std::uint16_t> codes = sweep.codes;
  const auto first = static_cast<float>(BeamSweep::FirstValueCode);
  // The first code above 0 dBZ.
  const float zero = sweep.step > 0.0F ? std::floor(-sweep.base / sweep.step) + 1.0F : first;
  const auto least = static_cast<std::uint16_t>(std::clamp(zero, first, 65'535.0F));
  for (std::size_t entry = 0; entry < sweep.azimuths.size(); ++entry)
  {
    if (LargestCode(sweep, entry) < BeamSweep::FirstValueCode)
    {
      continue;
    }
    const float azimuth = sweep.azimuths[entry];
    const float turned = azimuth < 0.0F     ? azimuth + 360.0F
                         : azimuth < 360.0F ? azimuth
                                            : azimuth - 360.0F;
    below.TurnTo(turned);
    above.TurnTo(turned);
    std::uint16_t* ray = codes.data() + entry * sweep.Stride();
    for (std::size_t gate = 0; gate < static_cast<std::size_t>(sweep.gates); ++gate)
    {
      if (ray[gate] >= least)
      {
        const float value = sweep.base + sweep.step * static_cast<float>(ray[gate]);
        const float sharpened = SharpenValue(value, below.At(gate), above.At(gate), beamWidth);
        const float code = static_cast<float>(ray[gate]) + (sharpened - value) / sweep.step;
        ray[gate] = static_cast<std::uint16_t>(std::clamp(code, first, 65'535.0F) + 0.5F);
      }
    }
    ray[sweep.gates] = ray[sweep.gates - 1];
  }
  return codes;
}

} // namespace

float SharpenValue(
  float value, const NeighbourEcho& below, const NeighbourEcho& above, float beamWidth)
{
  const float fall = SlopeTo(below, value, beamWidth);
  const float rise = SlopeTo(above, value, beamWidth);
  if (fall == 0.0F && rise == 0.0F)
  {
    return value;
  }
  // What the beam's other half holds must be known before an echo is said not to fill the beam; and
  // an echo between two weaker ones is taken to fill half the beam, not less: it may be clutter.
  const float gain = below.measured && above.measured ? SharpeningRange::Up : 0.0F;
  const float excess = 10.0F * std::log10(sideTable.At(fall) + sideTable.At(rise));
  return value - std::max(excess, -gain);
}

void SharpenSweeps(std::vector<BeamSweep>& sweeps, double beamWidth, const BeamModel& beam)
{
  std::vector<std::vector<std::uint16_t>> sharpened;
  for (const BeamSweep& sweep : sweeps)
  {
    sharpened.push_back(Sharpen(sweep, sweeps, static_cast<float>(beamWidth), beam));
  }
  for (std::size_t i = 0; i < sweeps.size(); ++i)
  {
    sweeps[i].codes = std::move(sharpened[i]);
  }
}

} // namespace nexrad
