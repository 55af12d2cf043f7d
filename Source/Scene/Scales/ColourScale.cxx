// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/Scales/ColourScale.h"

#include "nexrad/Model/Moment.h"

#include <algorithm>

namespace nexrad::scene
{
namespace
{

double ToBins(const ColourScale& scale, double value)
{
  return value * scale.factor + scale.offset;
}

// The colour of a bin at a value in the unit of the bins.
Colour ColourIn(const ColourBin& bin, double value)
{
  Colour colour = bin.colour;
  if (bin.ramp)
  {
    const double share = std::clamp((value - bin.from) / (bin.ramp->at - bin.from), 0.0, 1.0);
    std::transform(colour.begin(), colour.end(), bin.ramp->colour.begin(), colour.begin(),
      [share](double from, double to) { return from + share * (to - from); });
  }
  return colour;
}

} // namespace

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
  const auto above = std::upper_bound(scale.bins.begin(), scale.bins.end(), ToBins(scale, value),
    [](double wanted, const ColourBin& bin) { return wanted < bin.from; });
  const int bin = static_cast<int>(above - scale.bins.begin()) - 1;
  return scale.openBelow ? std::max(bin, 0) : bin;
}

std::optional<Colour> ColourAt(const ColourScale& scale, double value)
{
  const int bin = FindBin(scale, value);
  return bin < 0 ? std::nullopt
                 : std::optional(
                     ColourIn(scale.bins[static_cast<std::size_t>(bin)], ToBins(scale, value)));
}

ColourScale WithoutRamps(const ColourScale& scale)
{
  constexpr int pieces = 32;
  ColourScale cut = scale;
  cut.bins.clear();
  for (const ColourBin& bin : scale.bins)
  {
    const int count = bin.ramp ? pieces : 1;
    const double width = bin.ramp ? (bin.ramp->at - bin.from) / count : 0.0;
    for (int i = 0; i < count; ++i)
    {
      cut.bins.push_back({bin.from + width * i, ColourIn(bin, bin.from + width * (i + 0.5))});
    }
  }
  return cut;
}

bool HasRamps(const ColourTable& table)
{
  return std::any_of(
    table.begin(), table.end(), [](const ColourBin& bin) { return bin.ramp.has_value(); });
}

} // namespace nexrad::scene
