// SPDX-License-Identifier: BSD-3-Clause
#include "Gridding/BeamSharpening.h"

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

// An echo between two weaker ones is taken to fill half the beam, not less: it may be clutter.
constexpr float largestGain = 3.0F; // dB

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

// How much a tilt tells of the echo beside it, 0…1: what was not measured tells nothing, and what
// is fading does so without a jump.
float WorthOf(const TiltSample& sample)
{
  const bool measured = sample.state == VoxelState::Echo || sample.state == VoxelState::NoEcho;
  return measured && !sample.assumed ? sample.fade : 0.0F;
}

// From an echo to a neighbouring tilt, in the unit of the table; flat where that tells nothing.
float SlopeTo(const TiltSample& neighbour, float value, const TiltEdges& gap)
{
  const float step =
    neighbour.state == VoxelState::Echo ? neighbour.value - value : -value / gap.endShare;
  return WorthOf(neighbour) * gap.spread * step;
}

// The value of one tilt in the middle of the beam.
float Sharpen(const std::vector<TiltEdges>& edges, const TiltSample* samples, std::size_t tilt)
{
  static constexpr TiltSample nothing;
  const float value = samples[tilt].value;
  const TiltSample& lower = tilt > 0 ? samples[tilt - 1] : nothing;
  const TiltSample& upper = tilt + 1 < edges.size() ? samples[tilt + 1] : nothing;
  const float below = SlopeTo(lower, value, edges[std::max<std::size_t>(tilt, 1) - 1]);
  const float above = SlopeTo(upper, value, edges[tilt]);
  if (below == 0.0F && above == 0.0F)
  {
    return value;
  }
  // What the beam's other half holds must be known before an echo is said not to fill the beam.
  const float gain = largestGain * std::min(WorthOf(lower), WorthOf(upper));
  return value - std::max(10.0F * std::log10(sideTable.At(below) + sideTable.At(above)), -gain);
}

} // namespace

bool SharpenTilts(const std::vector<TiltEdges>& edges, const TiltSample* samples,
  std::vector<TiltSample>& sharpened)
{
  const auto isSharpened = [](const TiltSample& sample)
  { return sample.state == VoxelState::Echo && sample.value > 0.0F; };
  if (std::none_of(samples, samples + edges.size(), isSharpened))
  {
    return false;
  }
  sharpened.assign(samples, samples + edges.size());
  for (std::size_t i = 0; i < edges.size(); ++i)
  {
    if (isSharpened(samples[i]))
    {
      sharpened[i].value = Sharpen(edges, samples, i);
    }
  }
  return true;
}

} // namespace nexrad
