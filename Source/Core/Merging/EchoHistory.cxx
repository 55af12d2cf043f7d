// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Merging/EchoHistory.h"

namespace nexrad
{

void EchoHistory::Remember(const std::vector<ReadyVolume>& volumes)
{
  for (const ReadyVolume& volume : volumes)
  {
    if (volume.beam && volume.beam->moment == MomentName::REF)
    {
      const BeamVolume& beam = *volume.beam;
      Entry& entry = entries[{beam.site.name, beam.start}];
      if (!entry.summary)
      {
        entry.site = beam.site;
        entry.end = beam.end;
        entry.summary = std::make_shared<const VolumeSummary>(MakeSummary(beam));
      }
    }
  }
}

std::shared_ptr<const BeamVolume> EchoHistory::VolumeOf(Entry& entry, Time start)
{
  std::shared_ptr<const BeamVolume> made = entry.made.lock();
  if (!made)
  {
    BeamVolume volume;
    volume.site = entry.site;
    volume.start = start;
    volume.end = entry.end;
    volume.composite = CompositeOf(entry.summary->composite);
    volume.lowest = CompositeOf(entry.summary->lowest);
    made = std::make_shared<const BeamVolume>(std::move(volume));
    entry.made = made;
  }
  return made;
}

BeamVolumes EchoHistory::Find(const std::vector<std::pair<std::string, SeriesVolume>>& wanted)
{
  BeamVolumes volumes;
  for (const auto& [site, volume] : wanted)
  {
    const auto found = entries.find({site, volume.start});
    if (found == entries.end())
    {
      return {};
    }
    volumes.push_back(VolumeOf(found->second, volume.start));
  }
  return volumes;
}

BeamVolumes EchoHistory::Find(const std::vector<ReadyVolume>& wanted)
{
  BeamVolumes volumes;
  for (const ReadyVolume& each : wanted)
  {
    if (each.beam && each.beam->moment == MomentName::REF)
    {
      const Time start = each.beam->start;
      volumes.push_back(VolumeOf(entries.at({each.beam->site.name, start}), start));
    }
  }
  return volumes;
}

} // namespace nexrad
