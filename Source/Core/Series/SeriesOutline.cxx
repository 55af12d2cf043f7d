// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Series/SeriesOutline.h"

#include "nexrad/Level2/Level2File.h"

#include <algorithm>
#include <map>

namespace nexrad
{

std::optional<std::vector<SiteOutline>> OutlineSeries(
  const std::vector<std::filesystem::path>& paths, const std::string& siteName)
{
  std::map<std::string, SiteOutline> sites;
  for (std::size_t index = 0; index < paths.size(); ++index)
  {
    const std::optional<VolumeHeader> header = PeekVolumeHeader(paths[index]);
    const std::string name = header && siteName.empty() ? header->siteName : siteName;
    if (!header || !header->time || name.empty())
    {
      return std::nullopt;
    }
    SiteOutline& site = sites[name];
    site.name = name;
    site.files.push_back({index, *header->time});
  }
  std::vector<SiteOutline> outline;
  for (auto& [name, site] : sites)
  {
    std::stable_sort(site.files.begin(), site.files.end(),
      [](const OutlinedFile& a, const OutlinedFile& b) { return a.time < b.time; });
    outline.push_back(std::move(site));
  }
  return outline;
}

} // namespace nexrad
