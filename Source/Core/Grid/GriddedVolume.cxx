// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Grid/GriddedVolume.h"

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

// The radars of several volumes: each name once, with its position where all are known.
struct RadarList
{
  std::vector<std::string> names;
  std::vector<Position> positions;

  void Add(const GriddedVolume& volume)
  {
    const bool known = volume.sitePositions.size() == volume.sites.size();
    for (std::size_t i = 0; i < volume.sites.size(); ++i)
    {
      if (std::find(names.begin(), names.end(), volume.sites[i]) == names.end())
      {
        names.push_back(volume.sites[i]);
        if (known)
        {
          positions.push_back(volume.sitePositions[i]);
        }
      }
    }
  }
};

// Names a volume's radars by another list, which has all of them.
void SetSites(GriddedVolume& volume, const RadarList& radars)
{
  const std::vector<std::string>& sites = radars.names;
  volume.sitePositions =
    radars.positions.size() == sites.size() ? radars.positions : std::vector<Position>();
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

GriddedVolume WithoutVoxels(const GriddedVolume& volume)
{
  GriddedVolume description;
  static_cast<GriddedVolumeDescription&>(description) = volume;
  return description;
}

GriddedVolume JoinMoments(std::vector<GriddedVolume> moments)
{
  RadarList radars;
  for (const GriddedVolume& moment : moments)
  {
    radars.Add(moment);
  }
  const auto any = [&moments](bool GriddedVolume::*what)
  {
    return std::any_of(
      moments.begin(), moments.end(), [what](const GriddedVolume& moment) { return moment.*what; });
  };
  const bool synthetic = any(&GriddedVolume::synthetic);
  const bool sharpened = any(&GriddedVolume::sharpened);
  const float biological = std::max_element(moments.begin(), moments.end(),
    [](const GriddedVolume& a, const GriddedVolume& b) {
      return a.biologicalShare < b.biologicalShare;
    })->biologicalShare;
  // A moment that a radar lacks has no note of it.
  const std::vector<std::string> notes = std::max_element(moments.begin(), moments.end(),
    [](const GriddedVolume& a, const GriddedVolume& b) {
      return a.notes.size() < b.notes.size();
    })->notes;
  for (GriddedVolume& moment : moments)
  {
    SetSites(moment, radars);
    moment.notes = notes;
    moment.synthetic = synthetic;
    moment.sharpened = sharpened;
    moment.biologicalShare = biological;
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
