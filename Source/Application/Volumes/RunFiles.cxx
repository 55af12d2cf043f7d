// SPDX-License-Identifier: BSD-3-Clause
#include "Volumes/RunFiles.h"

namespace nexrad::application
{

RunFiles::RunFiles(
  VolumeFormat theFormat, const std::vector<std::string>& theRadars, bool isOneFile)
  : format(theFormat)
  , radars(theRadars)
  , oneFile(isOneFile)
{
  if (radars.empty())
  {
    radars.emplace_back();
  }
}

std::vector<std::string> RunFiles::At(Time time) const
{
  std::vector<std::string> names;
  for (const std::string& radar : radars)
  {
    names.push_back(VolumeFileName(time, format, radar).string());
  }
  return names;
}

std::vector<RunFiles::Series> RunFiles::SeriesOf(const std::vector<Time>& times) const
{
  std::vector<Series> all;
  for (const std::string& radar : radars)
  {
    Series series{(radar.empty() ? "volumes" : radar) + ExtensionOf(format), {}};
    series.name += oneFile ? "" : ".series";
    for (const Time time : times)
    {
      series.files.push_back(VolumeFileName(time, format, radar).string());
    }
    all.push_back(std::move(series));
  }
  return all;
}

} // namespace nexrad::application
