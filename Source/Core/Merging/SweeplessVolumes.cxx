// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Merging/SweeplessVolumes.h"

#include <algorithm>

namespace nexrad
{

ReadyVolume SweeplessVolumes::Make(
  const Site& site, const SeriesVolume& volume, const MergeRequest& request, MomentName moment)
{
  if (request.method == MergeMethod::Thesis)
  {
    return {std::make_shared<const PolarVolume>(
              PolarVolume{site, moment, volume.start, volume.end, volume.synthetic, {}, {}}),
      nullptr};
  }
  return {nullptr, this->MakeBeam(site, volume, moment, LooksForMotion(request, moment))};
}

std::shared_ptr<const BeamVolume> SweeplessVolumes::MakeBeam(
  const Site& site, const SeriesVolume& volume, MomentName moment, bool pictured)
{
  made.erase(std::remove_if(
               made.begin(), made.end(), [](const Made& each) { return each.volume.expired(); }),
    made.end());
  for (const Made& each : made)
  {
    if (each.summary == volume.summary && each.moment == moment && each.pictured == pictured)
    {
      return each.volume.lock();
    }
  }
  BeamVolume without;
  without.site = site;
  without.moment = moment;
  without.start = volume.start;
  without.end = volume.end;
  without.synthetic = volume.synthetic;
  if (pictured)
  {
    without.composite = CompositeOf(volume.summary->composite);
    without.lowest = CompositeOf(volume.summary->lowest);
  }
  auto own = std::make_shared<const BeamVolume>(std::move(without));
  made.push_back({volume.summary, moment, pictured, own});
  return own;
}

} // namespace nexrad
