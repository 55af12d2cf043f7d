// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Simulation/SimulatedDay.h"

#include "nexrad/Model/SiteTable.h"
#include "nexrad/Simulation/CounterNoise.h"
#include "nexrad/System/Error.h"

#include <algorithm>
#include <set>

namespace nexrad
{

namespace
{

Site RequireSite(const std::string& name)
{
  const KnownSite* known = FindSite(name);
  if (!known)
  {
    throw Error("site '" + name + "' is not in the site table; sites are named as in KLSX");
  }
  return {known->name, known->position};
}

// "KLSX20060312_180107": FormatForFileName's digits with an underscore.
std::string FileName(const SimulatedVolume& volume, const SimulatedDayOptions& options)
{
  const std::string stamp = FormatForFileName(volume.start);
  const std::size_t separator = stamp.find('T');
  std::string name =
    volume.site.name + stamp.substr(0, separator) + '_' + stamp.substr(separator + 1, 6);
  name += options.messageType == 31 ? "_V06" : "";
  return name + (options.container == Level2Container::Gzip ? ".gz" : "");
}

void AddVolumes(const SimulatedSite& site, const SimulatedDayOptions& options,
  std::vector<SimulatedVolume>& volumes)
{
  constexpr std::int64_t mostVolumeNumbers = 999;
  const Duration period = VolumePeriod(site.coveragePattern);
  SimulatedVolume volume;
  volume.site = RequireSite(site.name);
  volume.coveragePattern = site.coveragePattern;
  volume.bias = site.bias;
  // Starts are whole periods after the epoch, and a phase of the site's own.
  const double share = Uniform(KeyOf(site.name), 0);
  const Duration phase(static_cast<std::int64_t>(share * static_cast<double>(period.count())));
  const Duration since = options.begin.time_since_epoch() - phase;
  std::int64_t number = since / period;
  number += Duration(number * period) < since ? 1 : 0; // division rounds towards zero
  for (;; ++number)
  {
    volume.start = Time(phase + number * period);
    if (volume.start >= options.begin + options.length)
    {
      return;
    }
    volume.volumeNumber =
      static_cast<int>((number % mostVolumeNumbers + mostVolumeNumbers) % mostVolumeNumbers) + 1;
    volume.fileName = FileName(volume, options);
    volumes.push_back(volume);
  }
}

} // namespace

std::vector<SimulatedSite> SimulatedDayOptions::DefaultSites()
{
  return {{"KEAX", 21}, {"KILX", 12}, {"KLSX", 11}};
}

std::vector<SimulatedVolume> PlanSimulatedDay(const SimulatedDayOptions& options)
{
  if (options.sites.empty())
  {
    throw Error("simulated day: no sites; name at least one, as in KLSX");
  }
  if (options.length <= Duration(0))
  {
    throw Error("simulated day: its length must be above 0");
  }
  std::set<std::string> names;
  std::vector<SimulatedVolume> volumes;
  for (const SimulatedSite& site : options.sites)
  {
    if (!names.insert(site.name).second)
    {
      throw Error("simulated day: site " + site.name + " is named twice; a site scans one pattern");
    }
    AddVolumes(site, options, volumes);
  }
  std::sort(volumes.begin(), volumes.end(),
    [](const SimulatedVolume& first, const SimulatedVolume& second)
    {
      return first.start != second.start ? first.start < second.start
                                         : first.site.name < second.site.name;
    });
  return volumes;
}

std::vector<std::uint8_t> SimulateFile(
  const StormField& field, const SimulatedVolume& volume, const SimulatedDayOptions& options)
{
  SimulatorOptions simulator;
  simulator.superResolution = options.messageType == 31;
  simulator.seed = options.seed;
  simulator.effectiveRadiusFactor = options.effectiveRadiusFactor;
  simulator.notWeather = options.notWeather;
  simulator.dualPolarisation = options.dualPolarisation;
  simulator.bias = volume.bias;
  return EncodeLevel2(
    ScanVolume(field, volume.site, volume.coveragePattern, volume.start, simulator),
    {options.messageType, options.container, volume.volumeNumber});
}

} // namespace nexrad
