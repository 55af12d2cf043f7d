// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Merging/TimeMerge.h"

#include <map>
#include <memory>
#include <string>
#include <utility>
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
  using Key = std::pair<std::string, Time>; ///< radar and start

  /// A moment of a volume without sweeps, for a request; for Thesis it only names the radar.
  ReadyVolume Make(
    const Site& site, const SeriesVolume& volume, const MergeRequest& request, MomentName moment);

  /// Keeps the summaries of volumes of reflectivity that were made ready for the method Beam.
  void Remember(const std::vector<ReadyVolume>& volumes);
  /// Volumes of reflectivity; empty when one of them was not remembered.
  BeamVolumes Find(const std::vector<Key>& wanted);

private:
  struct Made
  {
    std::shared_ptr<const VolumeSummary> summary;
    MomentName moment{};
    bool pictured = false; // has the summary's picture
    std::weak_ptr<const BeamVolume> volume;
  };

  std::shared_ptr<const BeamVolume> MakeBeam(
    const Site& site, const SeriesVolume& volume, MomentName moment, bool pictured);

  std::vector<Made> made;
  std::map<Key, std::pair<Site, SeriesVolume>> remembered;
};

} // namespace nexrad
