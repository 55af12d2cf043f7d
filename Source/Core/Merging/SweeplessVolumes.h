// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Merging/TimeMerge.h"

#include <memory>
#include <vector>

namespace nexrad
{

/// Volumes of which nothing but the summary is there: of radars that do not reach a block, and of
/// times at which motion is searched and nothing merged. A summary needs some ten thousand bytes,
/// and no volume is decoded twice for it. A volume that was made of one is the same object as long
/// as somebody holds it, so that a search for motion knows it again.
class SweeplessVolumes
{
public:
  /// A moment of a volume without sweeps, for a request; for Thesis it only names the radar.
  ReadyVolume Make(
    const Site& site, const SeriesVolume& volume, const MergeRequest& request, MomentName moment);

  /// The same for Beam; `pictured`: with what motion is searched in.
  std::shared_ptr<const BeamVolume> MakeBeam(
    const Site& site, const SeriesVolume& volume, MomentName moment, bool pictured);

private:
  struct Made
  {
    std::shared_ptr<const VolumeSummary> summary;
    MomentName moment{};
    bool pictured = false; // has the summary's picture
    std::weak_ptr<const BeamVolume> volume;
  };

  std::vector<Made> made;
};

} // namespace nexrad
