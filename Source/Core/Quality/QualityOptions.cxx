// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Quality/QualityOptions.h"

#include <array>

namespace nexrad
{

namespace
{

constexpr std::array<QualityLevel, 3> levels = {
  QualityLevel::Off, QualityLevel::Standard, QualityLevel::Strict};

} // namespace

const char* ToString(QualityLevel level)
{
  constexpr std::array<const char*, levels.size()> names = {"off", "standard", "strict"};
  return names[static_cast<std::size_t>(level)];
}

std::optional<QualityLevel> ParseQualityLevel(std::string_view text)
{
  for (const QualityLevel level : levels)
  {
    if (text == ToString(level))
    {
      return level;
    }
  }
  return std::nullopt;
}

} // namespace nexrad
