// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Series/FileList.h"

#include "nexrad/Level2/Level2File.h"

#include <algorithm>
#include <map>

namespace nexrad
{

std::optional<std::vector<SiteFileList>> ListByHeaders(
  const std::vector<std::filesystem::path>& paths, const std::string& siteName)
{
  std::map<std::string, SiteFileList> sites;
  for (std::size_t index = 0; index < paths.size(); ++index)
  {
    const std::optional<VolumeHeader> header = PeekVolumeHeader(paths[index]);
    const std::string name = header && siteName.empty() ? header->siteName : siteName;
    if (!header || !header->time || name.empty())
    {
      return std::nullopt;
    }
    SiteFileList& site = sites[name];
    site.name = name;
    site.files.push_back({index, *header->time});
  }
  std::vector<SiteFileList> list;
  for (auto& [name, site] : sites)
  {
    std::stable_sort(site.files.begin(), site.files.end(),
      [](const TimedFile& a, const TimedFile& b) { return a.time < b.time; });
    list.push_back(std::move(site));
  }
  return list;
}

} // namespace nexrad
