// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Level2/VolumeEnding.h"

#include "nexrad/Model/SiteKey.h"

#include <algorithm>

namespace nexrad
{

namespace
{

// The cuts behind the last that was scanned.
void LeaveRest(int lastNumber, VolumeCuts& cuts)
{
  const auto rest = std::upper_bound(cuts.missing.begin(), cuts.missing.end(), lastNumber);
  cuts.notScanned.assign(rest, cuts.missing.end());
  cuts.missing.erase(rest, cuts.missing.end());
  cuts.end = VolumeEnd::NewVolume;
  cuts.left = Duration();
}

} // namespace

bool LacksEnd(const RadarVolume& volume)
{
  return !volume.cuts.empty() && volume.cuts.back().left > Duration();
}

void EndWithNext(RadarVolume& volume, const RadarVolume& next)
{
  const bool isSameRadar =
    KeyOf(volume.site) == KeyOf(next.site) && !StandApart(volume.site, next.site);
  if (!LacksEnd(volume) || next.cuts.empty() || !isSameRadar ||
      !IsBrokenOff(volume.cuts.back().left, *next.Start() - *volume.End(), next.cuts.front().begun))
  {
    return;
  }
  VolumeCuts& cuts = volume.cuts.back();
  LeaveRest(volume.sweeps.back().elevationNumber, cuts);
  const auto isEnd = [](const Damage& damage) { return damage.isMissingEnd; };
  volume.damage.erase(
    std::remove_if(volume.damage.begin(), volume.damage.end(), isEnd), volume.damage.end());
  volume.complete = std::all_of(volume.cuts.begin(), volume.cuts.end(),
    [](const VolumeCuts& each) { return each.missing.empty(); });
  volume.notes.push_back(DescribeCuts(cuts).back() + ", of " + next.file);
}

} // namespace nexrad
