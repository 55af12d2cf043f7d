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
  int digits;
};

constexpr std::array<MomentText, KnownMomentCount> momentTexts = {{{"REF", "dBZ", "Reflectivity",
                                                                     1},
  {"VEL", "m/s", "Radial velocity", 1}, {"SW", "m/s", "Spectrum width", 1},
  {"ZDR", "dB", "Differential reflectivity", 1}, {"PHI", "degrees", "Differential phase", 1},
  {"RHO", "", "Correlation coefficient", 3}, {"CFP", "dB", "Clutter filter power removed", 1},
  {"SRV", "m/s", "Storm-relative radial velocity", 1}, {"AZSHEAR", "1/s", "Azimuthal shear", 4},
  {"DIV", "1/s", "Radial divergence", 4}, {"KDP", "degrees/km", "Specific differential phase", 2}}};

const MomentText& TextsOf(MomentName name)
{
  return momentTexts[static_cast<std::size_t>(name)];
}

// "A, B or C".
std::string Listed(const MomentName* begin, const MomentName* end)
{
  std::string list;
  for (const MomentName* name = begin; name != end; ++name)
  {
    const char* before = name == begin ? "" : name + 1 == end ? " or " : ", ";
    list += before + std::string(ToString(*name));
  }
  return list;
}

} // namespace

MomentName MeasuredFor(MomentName name)
{
  switch (name)
  {
  case MomentName::SRV:
  case MomentName::AZSHEAR:
  case MomentName::DIV:
    return MomentName::VEL;
  case MomentName::KDP:
    return MomentName::PHI;
  default:
    return name;
  }
}

const char* ToString(MomentName name)
{
  return TextsOf(name).name;
}

const char* UnitOf(MomentName name)
{
  return TextsOf(name).unit;
}

int DigitsOf(MomentName name)
{
  return TextsOf(name).digits;
}

const char* TitleOf(MomentName name)
{
  return TextsOf(name).title;
}

std::optional<MomentName> ParseMomentName(std::string_view text)
{
  for (const MomentName name : KnownMoments)
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

std::string MomentNameList()
{
  return Listed(KnownMoments.begin(), KnownMoments.begin() + MomentCount) + ", or the derived " +
         Listed(KnownMoments.begin() + MomentCount, KnownMoments.end());
}

} // namespace nexrad
