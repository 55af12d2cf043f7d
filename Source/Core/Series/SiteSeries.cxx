// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Series/SiteSeries.h"

#include "nexrad/Grid/MakeGrid.h"
#include "nexrad/Model/SiteTable.h"

#include <algorithm>
#include <cmath>

namespace nexrad
{

bool SeriesVolume::Has(MomentName moment) const
{
  return std::find(lacking.begin(), lacking.end(), moment) == lacking.end();
}

std::vector<const SeriesVolume*> ChooseWith(
  MomentName moment, const std::vector<SeriesVolume>& volumes, const VolumeChoice& choose)
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
  for (const std::size_t index : choose(starts, ends))
  {
    chosen.push_back(own[index]);
  }
  return chosen;
}

std::vector<Time> SiteSeries::Starts() const
{
  std::vector<Time> starts;
  for (const SeriesVolume& volume : volumes)
  {
    starts.push_back(volume.start);
  }
  return starts;
}

std::vector<Time> SiteSeries::Ends() const
{
  std::vector<Time> ends;
  for (const SeriesVolume& volume : volumes)
  {
    ends.push_back(volume.end);
  }
  return ends;
}

std::optional<Time> SeriesScan::First() const
{
  std::optional<Time> first;
  for (const SiteSeries& series : sites)
  {
    first = std::min(first.value_or(series.volumes.front().start), series.volumes.front().start);
  }
  return first;
}

std::optional<Time> SeriesScan::Last() const
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

std::vector<TimeSpan> SeriesScan::Spans() const
{
  std::vector<TimeSpan> spans;
  for (const SiteSeries& series : sites)
  {
    for (const SeriesVolume& volume : series.volumes)
    {
      spans.push_back({volume.start, volume.end});
    }
  }
  return spans;
}

double RangeOf(const Site& site, const SeriesVolume& volume)
{
  constexpr double kilometre = 1'000.0; // m, to whole ones outwards: the faces read well
  return IsTerminal(site) && volume.reach > 0.0 ? kilometre * std::ceil(volume.reach / kilometre)
                                                : DefaultRange;
}

double SeriesScan::Range() const
{
  return sites.size() == 1 ? RangeOf(sites.front().site, sites.front().volumes.front())
                           : DefaultRange;
}

std::vector<Position> SeriesScan::Positions() const
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
