// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Series/ScannedFile.h"

#include "nexrad/Archives/StoredFiles.h"
#include "nexrad/Model/Elevation.h"
#include "nexrad/Model/Site.h"
#include "nexrad/Model/StrayRays.h"
#include "nexrad/Moments/MomentMaker.h"
#include "nexrad/System/Error.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iterator>
#include <map>
#include <new>
#include <sstream>

namespace nexrad
{

namespace
{

// Whether a volume has a moment, or what a derived one is made of.
bool HasMoment(const RadarVolume& volume, MomentName moment)
{
  return std::any_of(volume.sweeps.begin(), volume.sweeps.end(),
    [moment](const Sweep& sweep) { return sweep.Has(moment); });
}

// Of the moments asked for, those that a volume has, or does not have.
std::vector<MomentName> MomentsOf(
  const RadarVolume& volume, const SeriesOptions& options, bool has = true)
{
  std::vector<MomentName> moments = options.moments;
  const auto other = [&](MomentName moment) { return HasMoment(volume, moment) != has; };
  moments.erase(std::remove_if(moments.begin(), moments.end(), other), moments.end());
  return moments;
}

std::string NamesOf(const std::vector<MomentName>& moments)
{
  std::string names;
  for (const MomentName moment : moments)
  {
    names += (names.empty() ? "" : ", ") + std::string(ToString(moment));
  }
  return names;
}

/// Why a volume cannot be used; empty when it can.
std::string ReasonToLeaveOut(const RadarVolume& volume, const SeriesOptions& options)
{
  if (volume.sweeps.empty())
  {
    return "no ray could be read: left out";
  }
  if (options.requirePosition && !volume.site.position)
  {
    return "the position of site \"" + volume.site.name + "\" is unknown: left out";
  }
  if (!options.moments.empty() && MomentsOf(volume, options).empty())
  {
    return "no ray has " + NamesOf(options.moments) + ": left out";
  }
  return {};
}

// Slant range to which two tilts with the moment see, or the only one, m. A terminal radar sees
// far beyond the others with one cut, and its many high tilts end where they leave the weather.
double ReachOf(const RadarVolume& volume, MomentName moment)
{
  struct SweepReach
  {
    double reach;
    double elevation;
  };
  std::vector<SweepReach> sweeps;
  for (const Sweep& sweep : volume.sweeps)
  {
    const MomentRow& row = sweep.rays.front().Row(MeasuredFor(moment));
    if (row.gates > 0)
    {
      sweeps.push_back(
        {row.firstGate + (row.gates - 0.5) * row.gateSpacing, sweep.MedianElevation()});
    }
  }
  if (sweeps.empty())
  {
    return 0.0;
  }
  std::sort(sweeps.begin(), sweeps.end(),
    [](const SweepReach& a, const SweepReach& b) { return a.reach > b.reach; });
  const auto second = std::find_if(sweeps.begin(), sweeps.end(),
    [&farthest = sweeps.front()](const SweepReach& each)
    { return std::abs(each.elevation - farthest.elevation) > SameTilt; });
  return second == sweeps.end() ? sweeps.front().reach : second->reach;
}

SeriesVolume Describe(const RadarVolume& volume, const std::filesystem::path& path,
  std::size_t cycle, const SeriesOptions& options)
{
  const std::vector<MomentName> moments = MomentsOf(volume, options);
  SeriesVolume description;
  description.file = path;
  description.origin = path.filename().string();
  description.cycle = cycle;
  description.start = *volume.Start();
  description.end = *volume.End();
  if (!volume.cuts.empty())
  {
    description.begun = volume.cuts.front().begun;
    description.left = volume.cuts.front().left;
  }
  description.rays = volume.RayCount();
  description.reach = ReachOf(volume, moments.empty() ? MomentName::REF : moments.front());
  description.synthetic = volume.synthetic;
  std::copy_if(KnownMoments.begin(), KnownMoments.end(), std::back_inserter(description.moments),
    [&volume](MomentName moment) { return HasMoment(volume, moment); });
  return description;
}

/// Sorts a site's volumes and drops the poorer of two with the same first ray.
void SortVolumes(SiteSeries& series, std::vector<InputProblem>& problems)
{
  std::vector<SeriesVolume>& volumes = series.volumes;
  std::stable_sort(volumes.begin(), volumes.end(), IsBefore);
  std::vector<SeriesVolume> kept;
  for (SeriesVolume& volume : volumes)
  {
    if (!kept.empty() && kept.back().start == volume.start)
    {
      problems.push_back({volume.file.string(), {},
        "the same volume as " + kept.back().file.string() + ": left out", true});
      continue;
    }
    kept.push_back(std::move(volume));
  }
  volumes = std::move(kept);
}

// Volumes that the radar broke off for the next one, which another file holds, lack no end: a note
// takes the place of the damage.
void NoteRestarts(const std::vector<SeriesVolume>& volumes, SeriesScan& scan)
{
  for (std::size_t i = 0; i + 1 < volumes.size(); ++i)
  {
    const auto lacksEnd = [file = volumes[i].file.string()](const InputProblem& problem)
    { return problem.file == file && problem.isMissingEnd; };
    const auto damage = std::find_if(scan.problems.begin(), scan.problems.end(), lacksEnd);
    const std::string note = DescribeRestart(volumes[i], volumes[i + 1]);
    if (damage != scan.problems.end() && !note.empty())
    {
      scan.problems.erase(damage);
      scan.notes.push_back(note);
    }
  }
}

// What has to be known of all moments of a volume together.
void AddTo(VolumeSummary& all, VolumeSummary&& one)
{
  const double reach = std::max(all.reach, one.reach);
  if (all.composite.picture.empty())
  {
    all = std::move(one); // of reflectivity alone there is a picture
  }
  all.reach = reach;
}

// Makes what is asked for of a volume's moments. Returns a line on what they lack; empty for
// nothing.
std::string Visit(SeriesVolume& description, const RadarVolume& volume,
  const SeriesOptions& options, const VolumeVisitor& visitor)
{
  if (options.moments.empty() && visitor)
  {
    visitor(description, volume, nullptr);
  }
  if (!options.summaries && !options.lowEchoes && !visitor)
  {
    return {};
  }
  MomentMaker maker(volume, options);
  VolumeSummary summary;
  std::vector<std::shared_ptr<const PolarVolume>> clean;
  for (const MomentName moment : MomentsOf(volume, options))
  {
    clean.push_back(std::make_shared<const PolarVolume>(maker.Make(moment)));
    if (options.summaries)
    {
      AddTo(summary, MakeSummary(*clean.back()));
    }
    if (options.lowEchoes && moment == MomentName::REF && volume.site.position)
    {
      description.lowEcho = std::make_shared<const LowEcho>(*clean.back());
    }
  }
  if (options.summaries)
  {
    description.summary = std::make_shared<const VolumeSummary>(std::move(summary));
  }
  description.echo = maker.Echo();
  description.endsAt = clean.empty() ? std::nullopt : clean.front()->endsAt;
  for (std::size_t i = 0; visitor && i < clean.size(); ++i)
  {
    visitor(description, volume, clean[i]);
  }
  return maker.Note();
}

// Adds one cycle of a file, or why it is left out.
void AddCycle(const RadarVolume& volume, const std::filesystem::path& path, std::size_t cycle,
  const SeriesOptions& options, const VolumeVisitor& visitor, ScannedFile& scanned)
{
  const auto tell = [&](const std::string& what, bool leftOut)
  {
    if (!what.empty())
    {
      scanned.problems.push_back({path.string(), {}, what, leftOut});
    }
  };
  const std::string reason = ReasonToLeaveOut(volume, options);
  tell(reason, true);
  if (!reason.empty())
  {
    return;
  }
  scanned.volumes.emplace_back(volume.site, Describe(volume, path, cycle, options));
  SeriesVolume& description = scanned.volumes.back().second;
  const std::vector<MomentName> lacking = MomentsOf(volume, options, false);
  if (!lacking.empty())
  {
    tell("no ray has " + NamesOf(lacking), false);
  }
  if (const std::string strays = SummarizeStrays(volume); !strays.empty())
  {
    scanned.notes.push_back(path.string() + ": " + strays);
  }
  tell(Visit(description, volume, options, visitor), false);
}

// Where each radar stands by most of its volumes; of two places with as many, the first.
std::map<SiteKey, Site> FindSitePlaces(const std::vector<ScannedFile>& files)
{
  using Place = std::pair<Site, std::size_t>; // and how many volumes stand there
  std::map<SiteKey, std::vector<Place>> places;
  for (const ScannedFile& file : files)
  {
    for (const auto& [site, volume] : file.volumes)
    {
      if (site.position)
      {
        std::vector<Place>& own = places[KeyOf(site)];
        const auto same = std::find_if(own.begin(), own.end(),
          [&at = site](const Place& place) { return !StandApart(place.first, at); });
        ++(same != own.end() ? *same : own.emplace_back(Place{site, 0})).second;
      }
    }
  }
  const auto fewer = [](const Place& a, const Place& b) { return a.second < b.second; };
  std::map<SiteKey, Site> most;
  for (const auto& [key, own] : places)
  {
    most[key] = std::max_element(own.begin(), own.end(), fewer)->first;
  }
  return most;
}

ScannedFile ScanWithinMemory(
  const std::filesystem::path& path, const SeriesOptions& options, const VolumeVisitor& visitor)
{
  ScannedFile scanned;
  RadarVolume whole;
  try
  {
    whole = ReadLevel2(path, options.level2);
  }
  catch (const Error& error)
  {
    // An error names its file already.
    const std::string prefix = path.string() + ": ";
    std::string what = error.what();
    what = what.compare(0, prefix.size(), prefix) == 0 ? what.substr(prefix.size()) : what;
    scanned.problems.push_back({path.string(), {}, what, true});
    return scanned;
  }
  return ScanVolume(whole, path, options, visitor);
}

} // namespace

std::string OriginOf(const std::filesystem::path& path)
{
  return path.string() + ' ' + std::to_string(StoredSize(path)) + ' ' +
         std::to_string(ChangedAt(path).time_since_epoch().count());
}

bool TellsEcho(const ScannedFile& file)
{
  return std::any_of(file.volumes.begin(), file.volumes.end(),
    [](const auto& each) { return each.second.echo.has_value(); });
}

ScannedFile ScanVolume(const RadarVolume& whole, const std::filesystem::path& path,
  const SeriesOptions& options, const VolumeVisitor& visitor)
{
  ScannedFile scanned;
  for (const Damage& damage : whole.damage)
  {
    scanned.problems.push_back(
      {path.string(), damage.offset, damage.what, false, damage.isMissingEnd});
  }
  if (HoldsMetadataAlone(whole))
  {
    scanned.notes.push_back(path.string() + ": metadata alone, no ray: passed over");
    return scanned;
  }
  const std::vector<RadarVolume> cycles = SplitCycles(whole);
  for (std::size_t cycle = 0; cycle < cycles.size(); ++cycle)
  {
    AddCycle(cycles[cycle], path, cycle, options, visitor, scanned);
  }
  return scanned;
}

ScannedFile ScanFile(
  const std::filesystem::path& path, const SeriesOptions& options, const VolumeVisitor& visitor)
{
  const std::string origin = OriginOf(path);
  ScannedFile scanned;
  try
  {
    scanned = ScanWithinMemory(path, options, visitor);
  }
  catch (const std::bad_alloc&)
  {
    scanned.problems.push_back(
      {path.string(), {}, "needs more memory than there is: left out", true});
  }
  scanned.origin = origin;
  for (auto& [site, volume] : scanned.volumes)
  {
    volume.origin = origin;
  }
  return scanned;
}

std::string DescribeRestart(const SeriesVolume& volume, const SeriesVolume& next)
{
  return IsBrokenOff(volume.left, next.start - volume.end, next.begun)
           ? volume.file.string() + ": the radar broke the volume off and began the new one of " +
               next.file.string()
           : std::string();
}

std::string DescribePlaces(const Site& site, const Site& other)
{
  std::ostringstream text;
  text << std::fixed << std::setprecision(3) << "has a radar " << site.name << " at "
       << site.position->latitude << ", " << site.position->longitude
       << " degrees, and other files have it at " << other.position->latitude << ", "
       << other.position->longitude << " degrees: left out (--site names another radar)";
  return text.str();
}

SeriesScan CollectSeries(std::vector<InputProblem> problems, const std::vector<ScannedFile>& files)
{
  SeriesScan scan;
  scan.problems = std::move(problems);
  const std::map<SiteKey, Site> places = FindSitePlaces(files);
  for (std::size_t input = 0; input < files.size(); ++input)
  {
    const ScannedFile& file = files[input];
    scan.problems.insert(scan.problems.end(), file.problems.begin(), file.problems.end());
    scan.notes.insert(scan.notes.end(), file.notes.begin(), file.notes.end());
    for (const auto& [site, volume] : file.volumes)
    {
      const auto place = places.find(KeyOf(site));
      if (place != places.end() && StandApart(place->second, site))
      {
        scan.problems.push_back(
          {volume.file.string(), {}, DescribePlaces(site, place->second), true});
        continue;
      }
      SiteSeries& series = scan.Of(site);
      if (!series.site.position)
      {
        series.site = site;
      }
      series.volumes.push_back(volume);
      series.volumes.back().input = input;
    }
  }
  for (SiteSeries& series : scan.sites)
  {
    SortVolumes(series, scan.problems);
    NoteRestarts(series.volumes, scan);
  }
  return scan;
}

} // namespace nexrad
