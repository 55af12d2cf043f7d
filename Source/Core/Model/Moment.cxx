// SPDX-License-Identifier: BSD-3-Clause
#include "Model/Moment.h"

namespace nexrad
{

namespace
{

struct MomentText
{
  const char* name;
  const char* unit;
};

constexpr std::array<MomentText, MomentCount> momentTexts = {{{"REF", "dBZ"}, {"VEL", "m/s"},
  {"SW", "m/s"}, {"ZDR", "dB"}, {"PHI", "degrees"}, {"RHO", ""}, {"CFP", "dB"}}};

} // namespace

const char* ToString(MomentName name)
{
  return momentTexts[static_cast<std::size_t>(name)].name;
}

const char* UnitOf(MomentName name)
{
  return momentTexts[static_cast<std::size_t>(name)].unit;
}

std::optional<MomentName> ParseMomentName(std::string_view text)
{
  for (const MomentName name : AllMoments)
  {
    if (text == ToString(name))
    {
      return name;
    }
  }
  return std::nullopt;
}

} // namespace nexrad
