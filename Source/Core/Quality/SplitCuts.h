// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Polar/PolarVolume.h"
#include "nexrad/System/RangeLoop.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace nexrad
{

/// The measured moments of a volume that tell what its echo is.
struct MeasuredMoments
{
  const PolarVolume& reflectivity;
  PolarVolume velocity;
  PolarVolume width;
  PolarVolume correlation; ///< ρ_hv
  PolarVolume ratio;       ///< Z_DR
  PolarVolume phase;       ///< Φ_DP
  PolarVolume filterPower; ///< power that the clutter filter removed

  /// Makes them by `measured` up to the slant range `judged` of their sweeps, through a loop. The
  /// reflectivity must outlive them.
  MeasuredMoments(const PolarVolume& reflectivity, const MeasuredVolume& measured,
    const WantedRange& judged, const RangeLoop& loop);
};

/// Another moment in the directions of the rays of a sweep of reflectivity.
struct MomentSource
{
  const PolarSweep* sweep = nullptr; ///< nullptr where the volume has none
  std::vector<std::size_t> rays;     ///< the ray of `sweep` for each ray of the reflectivity; NoRay

  static constexpr std::size_t NoRay = static_cast<std::size_t>(-1);

  /// Whether there is a ray in the direction of a ray of the reflectivity.
  bool Has(std::size_t ray) const { return sweep != nullptr && rays[ray] != NoRay; }
};

/// What tells about the gates of one sweep of reflectivity. The halves of a split cut serve each
/// other: the surveillance half has ρ_hv, Z_DR and Φ_DP, the Doppler half velocity and spectrum
/// width.
struct SweepSources
{
  MomentSource velocity;
  MomentSource width;
  MomentSource correlation;
  MomentSource ratio;
  MomentSource phase;
  MomentSource filterPower;
  /// Of the Doppler half of a split cut that has reflectivity: the sweep of reflectivity that is
  /// its surveillance half.
  std::optional<std::size_t> surveillance;
};

/// The sources of the sweeps of reflectivity, in their order. `moments` must outlive them.
std::vector<SweepSources> FindSources(const MeasuredMoments& moments);

} // namespace nexrad
