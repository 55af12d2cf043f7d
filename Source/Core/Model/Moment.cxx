// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Model/Moment.h"

#include <algorithm>

namespace nexrad
{

namespace
{

struct MomentText
{
  const char* name;
  const char* unit;
  const char* title;
};

constexpr std::array<MomentText, MomentCount> momentTexts = {{{"REF", "dBZ", "Reflectivity"},
  {"VEL", "m/s", "Radial velocity"}, {"SW", "m/s", "Spectrum width"},
  {"ZDR", "dB", "Differential reflectivity"}, {"PHI", "degrees", "Differential phase"},
  {"RHO", "", "Correlation coefficient"}, {"CFP", "dB", "Clutter filter power removed"}}};

} // namespace

const char* ToString(MomentName name)
{
  return momentTexts[static_cast<std::size_t>(name)].name;
}

const char* UnitOf(MomentName name)
{
  return momentTexts[static_cast<std::size_t>(name)].unit;
}

const char* TitleOf(MomentName name)
{
  return momentTexts[static_cast<std::size_t>(name)].title;
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

std::vector<MomentName> ParseMomentNames(std::string_view text)
{
  std::vector<MomentName> moments;
  for (std::size_t begin = 0; begin <= text.size();)
  {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const auto moment = ParseMomentName(text.substr(begin, end - begin));
    if (!moment || std::find(moments.begin(), moments.end(), *moment) != moments.end())
    {
      return {};
    }
    moments.push_back(*moment);
    begin = end + 1;
  }
  return moments;
}

} // namespace nexrad
