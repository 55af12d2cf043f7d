// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/Scales/ColourScale.h"

#include "nexrad/Model/Moment.h"

#include <algorithm>

namespace nexrad::scene
{

ColourScale MomentScale(const std::string& array, const ColourTable& table)
{
  ColourScale scale;
  scale.bins = table;
  scale.title = array;
  if (const auto moment = ParseMomentName(array))
  {
    scale.unit = UnitOf(*moment);
    scale.title = TitleOf(*moment);
    scale.title += IsRadialVelocity(*moment) ? ", positive away from the radar" : "";
    scale.openBelow = *moment != MomentName::REF;
  }
  return scale;
}

int FindBin(const ColourScale& scale, double value)
{
  const auto above = std::upper_bound(scale.bins.begin(), scale.bins.end(), value * scale.factor,
    [](double wanted, const ColourBin& bin) { return wanted < bin.from; });
  const int bin = static_cast<int>(above - scale.bins.begin()) - 1;
  return scale.openBelow ? std::max(bin, 0) : bin;
}

} // namespace nexrad::scene
