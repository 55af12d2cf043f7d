// SPDX-License-Identifier: BSD-3-Clause
#include "ScannedDay.h"

#include "Coverage.h"
#include "StormMeans.h"
#include "nexrad/Grid/MakeGrid.h"
#include "nexrad/Series/VolumeSelection.h"

#include <algorithm>
#include <cstdio>
#include <map>
#include <utility>

namespace nexrad::testing
{

using namespace std::chrono_literals;

Time Evening()
{
  return *ParseIso8601("2006-03-12T18:05:00Z");
}

ScannedDay::ScannedDay(Time theTime, const SimulatorOptions& theOptions)
  : time(theTime)
  , options(theOptions)
{
  SimulatedDayOptions period;
  period.begin = time - 15min;
  period.length = 30min;
  std::map<std::string, std::vector<SimulatedVolume>> plans;
  for (const SimulatedVolume& volume : PlanSimulatedDay(period))
  {
    plans[volume.site.name].push_back(volume);
  }
  for (const auto& plan : plans)
  {
    this->AddSite(plan.second);
  }
}

void ScannedDay::AddSite(const std::vector<SimulatedVolume>& plan)
{
  std::vector<Time> starts;
  std::vector<Time> ends;
  for (const SimulatedVolume& volume : plan)
  {
    starts.push_back(volume.start);
    ends.push_back(volume.start + VolumePeriod(volume.coveragePattern));
  }
  const std::vector<std::size_t> bracket = FindBracket(starts, time, 15min);
  Scanned site;
  for (const std::size_t index : FindVolumesAbout(starts, ends, time, 15min))
  {
    if (index == bracket.at(0))
    {
      site.before = site.volumes.size();
    }
    if (index == bracket.at(1))
    {
      site.after = site.volumes.size();
    }
    const SimulatedVolume& each = plan[index];
    site.volumes.push_back(MakePolarVolume(
      ScanVolume(field, each.site, each.coveragePattern, each.start, options), MomentName::REF));
  }
  sites.push_back(std::move(site));
}

std::vector<SiteBracket> ScannedDay::Brackets() const
{
  std::vector<SiteBracket> brackets;
  for (const Scanned& site : sites)
  {
    brackets.push_back({&site.volumes[site.before], &site.volumes[site.after]});
  }
  return brackets;
}

std::vector<Position> ScannedDay::Positions() const
{
  std::vector<Position> positions;
  for (const Scanned& site : sites)
  {
    positions.push_back(*site.volumes.front().site.position);
  }
  return positions;
}

std::vector<const PolarVolume*> ScannedDay::BracketVolumes() const
{
  std::vector<const PolarVolume*> all;
  for (const SiteBracket& bracket : this->Brackets())
  {
    all.insert(all.end(), {bracket.before, bracket.after});
  }
  return all;
}

std::vector<const PolarVolume*> ScannedDay::Volumes() const
{
  std::vector<const PolarVolume*> all;
  for (const Scanned& site : sites)
  {
    for (const PolarVolume& volume : site.volumes)
    {
      all.push_back(&volume);
    }
  }
  return all;
}

void ScannedDay::ChangeRays(const std::function<void(PolarRay&)>& change)
{
  for (Scanned& site : sites)
  {
    for (PolarVolume& volume : site.volumes)
    {
      for (PolarSweep& sweep : volume.sweeps)
      {
        std::for_each(sweep.rays.begin(), sweep.rays.end(), change);
      }
    }
  }
}

const ScannedDay& EveningDay()
{
  static const ScannedDay day(Evening());
  return day;
}

GridSpecification GridOf(const ScannedDay& day, const std::array<int, 3>& dimensions)
{
  GridRequest request;
  request.dimensions = dimensions;
  return MakeGrid(request, day.Positions());
}

Truth TruthOn(const ScannedDay& day, const std::array<int, 3>& dimensions)
{
  // Many tests ask for the same one; radars and their atmosphere change nothing of it.
  static std::map<std::pair<Time, std::array<int, 3>>, std::vector<float>> known;
  std::vector<float>& values = known[{day.At(), dimensions}];
  Truth truth;
  truth.grid = GridOf(day, dimensions);
  if (values.empty())
  {
    values = MeanReflectivityRows(day.Field(), truth.grid, 0, dimensions[1], day.At());
  }
  truth.values = values;
  truth.counts = BeamCoverage(day.BracketVolumes(), truth.grid);
  return truth;
}

std::string ToText(const std::array<int, 3>& dimensions)
{
  return std::to_string(dimensions[0]) + "x" + std::to_string(dimensions[1]) + "x" +
         std::to_string(dimensions[2]);
}

void Print(const std::string& method, const Truth& truth, const TruthScore& score)
{
  std::printf("%-8s %-12s RMSE %5.2f dBZ  bias %+5.2f dBZ  missed %6.3f %%  false %6.3f %%  "
              "(%zu voxels, %zu with echo)\n",
    method.c_str(), ToText(truth.grid.dimensions).c_str(), score.rmse, score.bias,
    100.0 * score.MissedFraction(), 100.0 * score.FalseFraction(), score.voxels, score.trueEcho);
}

} // namespace nexrad::testing
