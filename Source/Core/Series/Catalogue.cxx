// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Series/Catalogue.h"

#include "nexrad/Model/SiteTable.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

namespace nexrad
{

bool SeriesVolume::Has(MomentName moment) const
{
  return moments.empty() || std::find(moments.begin(), moments.end(), moment) != moments.end();
}

bool IsBefore(const SeriesVolume& a, const SeriesVolume& b)
{
  return a.start != b.start ? a.start < b.start
         : a.rays != b.rays ? a.rays > b.rays
                            : a.input < b.input;
}

void SiteSeries::Put(const SeriesVolume& volume)
{
  const auto place = std::lower_bound(volumes.begin(), volumes.end(), volume.start,
    [](const SeriesVolume& each, Time start) { return each.start < start; });
  if (place == volumes.end() || place->start != volume.start)
  {
    volumes.insert(place, volume);
  }
  else if (IsBefore(volume, *place))
  {
    *place = volume;
  }
}

std::vector<const SeriesVolume*> SiteSeries::ChosenAt(
  Time time, const VolumeRule& rule, MomentName moment) const
{
  std::vector<const SeriesVolume*> own;
  std::vector<Time> starts;
  std::vector<Time> ends;
  for (const SeriesVolume& volume : volumes)
  {
    if (volume.Has(moment))
    {
      own.push_back(&volume);
      starts.push_back(volume.start);
      ends.push_back(volume.end);
    }
  }
  std::vector<const SeriesVolume*> chosen;
  for (const std::size_t index : ChooseVolumes(starts, ends, time, rule))
  {
    chosen.push_back(own[index]);
  }
  return chosen;
}

SiteSeries& Catalogue::Of(const Site& site)
{
  const SiteKey key = KeyOf(site);
  const auto place = std::lower_bound(sites.begin(), sites.end(), key,
    [](const SiteSeries& each, const SiteKey& wanted) { return KeyOf(each.site) < wanted; });
  return place != sites.end() && KeyOf(place->site) == key ? *place
                                                           : *sites.insert(place, {site, {}});
}

std::vector<ChosenVolume> Catalogue::ChosenAt(
  Time time, const VolumeRule& rule, const std::vector<MomentName>& moments) const
{
  std::vector<ChosenVolume> chosen;
  for (const MomentName moment : moments)
  {
    for (std::size_t site = 0; site < sites.size(); ++site)
    {
      for (const SeriesVolume* volume : sites[site].ChosenAt(time, rule, moment))
      {
        chosen.push_back({moment, site, volume});
      }
    }
  }
  return chosen;
}

std::string Catalogue::MadeOf(
  Time time, const VolumeRule& rule, const std::vector<MomentName>& moments) const
{
  std::set<std::string> lines; // whatever the order of the radars
  for (const auto& [moment, site, volume] : this->ChosenAt(time, rule, moments))
  {
    lines.insert(std::string("\n") + ToString(moment) + ' ' + sites[site].site.name + ' ' +
                 FormatIso8601(volume->start) + ' ' + FormatIso8601(volume->end) + ' ' +
                 std::to_string(volume->rays) + ' ' + volume->origin + ' ' +
                 std::to_string(volume->cycle));
  }
  return std::accumulate(lines.begin(), lines.end(), std::string());
}

std::optional<Time> Catalogue::First() const
{
  const std::vector<TimeSpan> spans = this->Spans();
  return spans.empty() ? std::nullopt : std::optional(spans.front().first);
}

std::optional<Time> Catalogue::Last() const
{
  std::optional<Time> last;
  for (const SiteSeries& series : sites)
  {
    for (const SeriesVolume& volume : series.volumes)
    {
      last = std::max(last.value_or(volume.end), volume.end);
    }
  }
  return last;
}

std::vector<TimeSpan> Catalogue::Spans() const
{
  std::vector<TimeSpan> spans;
  for (const SiteSeries& series : sites)
  {
    for (const SeriesVolume& volume : series.volumes)
    {
      spans.push_back({volume.start, volume.end});
    }
  }
  std::stable_sort(spans.begin(), spans.end(),
    [](const TimeSpan& a, const TimeSpan& b) { return a.first < b.first; });
  return spans;
}

double RangeOf(const Site& site, const SeriesVolume& volume)
{
  constexpr double kilometre = 1'000.0; // m, to whole ones outwards: the faces read well
  return IsTerminal(site) && volume.reach > 0.0 ? kilometre * std::ceil(volume.reach / kilometre)
                                                : DefaultRange;
}

double Catalogue::Range() const
{
  return sites.size() == 1 ? RangeOf(sites.front().site, sites.front().volumes.front())
                           : DefaultRange;
}

std::vector<Position> Catalogue::Positions() const
{
  std::vector<Position> positions;
  for (const SiteSeries& series : sites)
  {
    if (series.site.position)
    {
      positions.push_back(*series.site.position);
    }
  }
  return positions;
}

} // namespace nexrad
