// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Model/VolumeCuts.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace nexrad
{

const char* ToString(VolumeEnd end)
{
  constexpr std::array<const char*, 4> texts = {"missing", "last cut", "early", "new volume"};
  return texts[static_cast<std::size_t>(end)];
}

std::string CutsText(const std::vector<int>& numbers)
{
  std::vector<std::string> parts;
  for (std::size_t begin = 0; begin < numbers.size();)
  {
    std::size_t end = begin + 1;
    while (end < numbers.size() && numbers[end] == numbers[end - 1] + 1)
    {
      ++end;
    }
    const bool isRange = end - begin > 2;
    end = isRange ? end : begin + 1;
    parts.push_back(
      std::to_string(numbers[begin]) + (isRange ? " to " + std::to_string(numbers[end - 1]) : ""));
    begin = end;
  }
  std::string text = numbers.size() == 1 ? "cut " : "cuts ";
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    text += (i == 0 ? "" : i + 1 == parts.size() ? " and " : ", ") + parts[i];
  }
  return text;
}

namespace
{

std::string DescribeRepeated(const VolumeCuts& cuts)
{
  constexpr double sameElevation = 0.2; // degrees
  const std::vector<CoverageCut>& all = cuts.pattern->cuts;
  const double lowest = std::min_element(all.begin(), all.end(),
    [](const CoverageCut& a, const CoverageCut& b) {
      return a.elevation < b.elevation;
    })->elevation;
  const bool areLowest = std::all_of(cuts.repeated.begin(), cuts.repeated.end(),
    [&](int number)
    { return all[static_cast<std::size_t>(number) - 1].elevation < lowest + sameElevation; });
  const char* scheme = IsTerminalPattern(cuts.pattern->number) ? ""
                       : areLowest                             ? " (SAILS)"
                                                               : " (MRLE)";
  return CutsText(cuts.repeated) + " again at " +
         (areLowest ? "the lowest elevation" : "low elevations") + scheme;
}

} // namespace

std::vector<std::string> DescribeCuts(const VolumeCuts& cuts)
{
  std::vector<std::string> lines;
  if (cuts.excerpt)
  {
    lines.push_back("an excerpt of a volume: without " + CutsText(cuts.missing) +
                    (cuts.expected ? " of " + std::to_string(*cuts.expected) : ""));
  }
  if (!cuts.repeated.empty() && cuts.pattern)
  {
    lines.push_back(DescribeRepeated(cuts));
  }
  const std::string place = cuts.notScanned.empty()
                              ? std::string()
                              : " after cut " + std::to_string(cuts.notScanned.front() - 1) +
                                  " of " + std::to_string(cuts.notScanned.back());
  if (cuts.end == VolumeEnd::NewVolume)
  {
    lines.push_back("the radar broke the volume off" + place + " and began a new one");
  }
  if (cuts.end == VolumeEnd::Early)
  {
    lines.push_back("the radar ended the volume" + place + ", as AVSET does");
  }
  return lines;
}

} // namespace nexrad
