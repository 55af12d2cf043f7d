// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Grid/VolumeMoments.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <string>
#include <utility>

namespace nexrad
{

namespace
{

// Names a volume's radars by another list, which has all of them.
void SetSites(GriddedVolume& volume, const std::vector<std::string>& sites)
{
  if (volume.sites == sites)
  {
    return;
  }
  std::array<std::uint8_t, 256> index{};
  index.fill(AncillaryArrays::NoSite);
  for (std::size_t i = 0; i < std::min<std::size_t>(volume.sites.size(), AncillaryArrays::NoSite);
       ++i)
  {
    const auto place = std::find(sites.begin(), sites.end(), volume.sites[i]);
    index[i] = static_cast<std::uint8_t>(place - sites.begin());
  }
  for (std::uint8_t& site : volume.ancillary.nearestSite)
  {
    site = index[site];
  }
  volume.sites = sites;
}

} // namespace

GriddedVolume JoinMoments(std::vector<GriddedVolume> moments)
{
  std::vector<std::string> sites = moments.front().sites;
  for (const GriddedVolume& moment : moments)
  {
    std::copy_if(moment.sites.begin(), moment.sites.end(), std::back_inserter(sites),
      [&](const std::string& site)
      { return std::find(sites.begin(), sites.end(), site) == sites.end(); });
  }
  const bool synthetic = std::any_of(
    moments.begin(), moments.end(), [](const GriddedVolume& moment) { return moment.synthetic; });
  for (GriddedVolume& moment : moments)
  {
    SetSites(moment, sites);
    moment.synthetic = synthetic;
  }
  GriddedVolume joined = std::move(moments.front());
  joined.further.assign(
    std::make_move_iterator(moments.begin() + 1), std::make_move_iterator(moments.end()));
  return joined;
}

std::vector<GriddedVolume> SplitMoments(GriddedVolume volume)
{
  std::vector<GriddedVolume> moments = std::move(volume.further);
  volume.further.clear();
  moments.insert(moments.begin(), std::move(volume));
  return moments;
}

} // namespace nexrad
