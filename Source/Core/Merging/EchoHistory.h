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

/// What the search for motion looks at, of all volumes of reflectivity that were decoded: it needs
/// some ten thousand bytes a volume, and no volume is decoded twice for it.
class EchoHistory
{
public:
  /// Keeps what is not kept yet of volumes made ready for the method Beam.
  void Remember(const std::vector<ReadyVolume>& volumes);

  /// Volumes without sweeps, by radar and start; empty when one of them was not remembered.
  BeamVolumes Find(const std::vector<std::pair<std::string, SeriesVolume>>& wanted);

  /// The same volumes without sweeps, of which those of reflectivity were remembered.
  BeamVolumes Find(const std::vector<ReadyVolume>& volumes);

private:
  struct Entry
  {
    Site site;
    std::shared_ptr<const VolumeSummary> summary;
    std::weak_ptr<const BeamVolume> made; // as long as somebody holds it
    Time end{};
  };
  using Key = std::pair<std::string, Time>;

  static std::shared_ptr<const BeamVolume> VolumeOf(Entry& entry, Time start);

  std::map<Key, Entry> entries;
};

} // namespace nexrad
