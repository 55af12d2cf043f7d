// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Gridding/BeamSampling.h"
#include "nexrad/Gridding/BeamTilts.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace nexrad
{

/// The sample of a tilt over columns about which no gate holds anything but no echo. It follows
/// from one observation before and one after the time, or one alone where there is none on the
/// other side; they are complete in azimuth and near enough in time to count in full.
struct QuietTilt
{
  const BeamSweep* before = nullptr; ///< nullptr: unknown
  const BeamSweep* after = nullptr;
  bool alone = false;         ///< `before` and `after` are the one observation that there is
  float nearest = 0.0F;       ///< tan(γ/2) from which both have gates
  float farthest = 0.0F;      ///< and to which
  std::uint8_t elevation = 0; ///< ElevationCode of the lowest sweep of any observation
};

/// Unknown too while TiltSample::age is wanted, which differs from ray to ray.
QuietTilt FindQuiet(const BeamTilt& tilt, const SamplingContext& context);

/// SampleTilt for a column about which no sweep as high as `quiet.elevation` holds anything but no
/// echo, or of a tilt that is alone, no sweep at all; false where it must be asked.
bool SampleQuiet(const QuietTilt& quiet, const ColumnDirection& column,
  const SamplingContext& context, TiltSample& sample);

/// How much an observation must count, at least, that it does is more than rounding.
constexpr float LeastFade = 1e-4F;

/// What the tilts of a radar have over columns about which no gate holds anything but no echo, as
/// far as the distance alone tells. Most columns of a large grid are such: their tilts are not
/// looked up one by one.
class QuietZones
{
public:
  enum class Tilt : std::uint8_t
  {
    Unknown,     ///< must be sampled
    NoEcho,      ///< its sample is no echo and counts in full
    AgingNoEcho, ///< its sample is no echo and counts, but less where its age is larger
    NotScanned   ///< beyond all gates, and below the height up to which weather reaches
  };

  /// One zone in which all tilts are unknown.
  QuietZones() = default;
  /// `quiet` is FindQuiet of each of the tilts.
  QuietZones(const std::vector<BeamTilt>& tilts, const std::vector<QuietTilt>& quiet,
    const SamplingContext& context);

  /// What each tilt has at a distance; nullptr: all are unknown.
  const Tilt* At(const ColumnDirection& column) const;

private:
  std::size_t tiltCount = 0;
  std::vector<float> ends; // tan(γ/2), ascending, of the zones but the last
  std::vector<Tilt> tilts; // of each zone
};

} // namespace nexrad
