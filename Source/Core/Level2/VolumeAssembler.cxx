// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Level2/VolumeAssembler.h"

#include "nexrad/Level2/Assembly/CutCheck.h"
#include "nexrad/Level2/Assembly/RadarVote.h"
#include "nexrad/Level2/Assembly/RayOrder.h"
#include "nexrad/Level2/MomentChecks.h"
#include "nexrad/Level2/SiteResolution.h"
#include "nexrad/Model/StrayRays.h"
#include "nexrad/Model/SweepWaveforms.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace nexrad
{

namespace
{

// Twenty times as many as any volume has. Without a limit a few compressed megabytes of empty rays
// would fill the memory.
constexpr std::size_t mostRays = 300'000;
// More than any file has: one for each of its volumes.
constexpr std::size_t mostPatterns = 100;

bool HasData(const Ray& ray)
{
  return std::any_of(
    ray.moments.begin(), ray.moments.end(), [](const MomentRow& row) { return row.gates > 0; });
}

} // namespace

VolumeAssembler::VolumeAssembler(Level2Options readOptions)
  : options(std::move(readOptions))
{
}

void VolumeAssembler::BeginPiece(const std::string& name)
{
  pieces.push_back(name + ": ");
}

void VolumeAssembler::AddHeader(const VolumeHeader& header)
{
  hasHeader = true;
  headerName = header.siteName;
  volume.headerTime = header.time;
}

void VolumeAssembler::AddPattern(CoveragePattern pattern)
{
  if (patterns.size() < mostPatterns)
  {
    patterns.push_back(std::move(pattern));
  }
}

void VolumeAssembler::AddStatus(const RadarStatus& status)
{
  if (statuses.size() < mostPatterns)
  {
    statuses.push_back(status);
  }
}

void VolumeAssembler::AddRay(DecodedRay&& decoded, int messageType, std::uint64_t offset)
{
  for (const std::string& problem : decoded.problems)
  {
    this->AddDamage(offset, problem);
  }
  if (!decoded.problems.empty() && !HasData(decoded.ray))
  {
    return;
  }
  if (arrived.size() == mostRays)
  {
    this->AddDamage(offset, "more than " + std::to_string(mostRays) + " rays; the rest is left");
    return;
  }
  arrived.push_back({std::move(decoded), messageType, offset, pieces.size() - 1});
}

void VolumeAssembler::AddDamage(std::uint64_t offset, const std::string& what)
{
  damage.Add(offset, pieces.back() + what);
}

void VolumeAssembler::Report(const ArrivedRay& at, const std::string& what)
{
  damage.Add(at.offset, pieces[at.piece] + what);
}

void VolumeAssembler::AddSweeps(const std::vector<ArrivedSweep>& sweeps)
{
  for (const ArrivedSweep& sweep : sweeps)
  {
    Sweep& added = volume.sweeps.emplace_back();
    added.elevationNumber = sweep.ElevationNumber();
    added.rays.reserve(sweep.rays.size());
    for (const ArrivedRay* ray : sweep.rays)
    {
      added.rays.push_back(ray->ray);
    }
    volume.messageType = sweep.rays.front()->messageType; // all rays of one radar have the same
  }
}

void VolumeAssembler::NoteTimes()
{
  constexpr auto usualDifference = std::chrono::seconds(10);
  constexpr auto day = std::chrono::hours(24);
  const auto start = volume.Start();
  const auto end = volume.End();
  if (!start || !end)
  {
    return;
  }
  if (volume.headerTime && std::chrono::abs(*volume.headerTime - *start) > usualDifference)
  {
    volume.notes.push_back("the header's time, " + FormatIso8601(*volume.headerTime) +
                           ", is not that of the first ray, " + FormatIso8601(*start));
  }
  if (start->time_since_epoch() / day != end->time_since_epoch() / day)
  {
    volume.notes.push_back("the volume continues after midnight UTC");
  }
}

void VolumeAssembler::NoteCuts()
{
  for (std::size_t index = 0; index < volume.cuts.size(); ++index)
  {
    const std::string place =
      volume.cuts.size() > 1 ? "volume " + std::to_string(index + 1) + " of the file: " : "";
    for (const std::string& line : DescribeCuts(volume.cuts[index]))
    {
      volume.notes.push_back(place + line);
    }
  }
}

// Without a ray. The archive has files that hold metadata alone, beside those of the volumes.
void VolumeAssembler::CheckMetadata(std::uint64_t size)
{
  if (hasHeader && pieces.size() == 1 && volume.damage.empty() && !metadata.empty())
  {
    std::string types;
    for (const unsigned type : metadata)
    {
      types += (types.empty() ? "" : ", ") + std::to_string(type);
    }
    volume.notes.push_back("metadata alone, no ray: message " + types);
    return;
  }
  const char* what = hasHeader
                       ? "no ray can be read"
                       : "no ray can be read, and no volume header: is this a Level II file?";
  volume.damage.push_back({size, pieces.back() + what});
}

// Damage that is there however long the list is.
void VolumeAssembler::CheckEnd(std::uint64_t size)
{
  if (volume.sweeps.empty())
  {
    this->CheckMetadata(size);
    return;
  }
  const VolumeCuts& last = volume.cuts.back();
  if (last.end != VolumeEnd::Missing)
  {
    return;
  }
  const auto rest = std::upper_bound(
    last.missing.begin(), last.missing.end(), volume.sweeps.back().elevationNumber);
  const std::vector<int> lost(rest, last.missing.end());
  volume.damage.push_back({size,
    pieces.back() + "no end of volume: its last rays are missing" +
      (lost.empty() ? "" : ", and " + CutsText(lost) + " of " + std::to_string(*last.expected)),
    true});
}

RadarVolume VolumeAssembler::Finish(const std::string& name, std::uint64_t size)
{
  const auto report = [this](const ArrivedRay& at, const std::string& what)
  { this->Report(at, what); };
  volume.file = name;
  RayList rays;
  for (ArrivedRay& ray : arrived)
  {
    rays.push_back(&ray);
  }
  const RadarOfRays radar = KeepOneRadar(rays, headerName, report);
  OrderRays(rays, volume.headerTime, report, volume.notes);
  const std::vector<ArrivedSweep> sweeps = BuildSweeps(rays, report, volume.notes);
  this->AddSweeps(sweeps);
  CheckCuts(sweeps, patterns, volume, report);
  CheckMoments(volume, [&](std::size_t sweep, std::size_t ray, const std::string& what)
    { this->Report(*sweeps[sweep].rays[ray], what); });
  volume.damage = damage.Take(pieces.size() == 1);
  this->CheckEnd(size);
  this->ChoosePattern();
  ResolveSite(headerName, radar, options, volume);
  ResolveWaveforms(volume);
  this->NoteTimes();
  this->NoteCuts();
  // The decoder keeps rays that the antenna sent while it was not at its cut.
  for (std::string& stray : DescribeStrays(volume))
  {
    volume.notes.push_back(std::move(stray));
  }
  if (volume.synthetic)
  {
    volume.notes.push_back("SYNTHETIC: the file says that it was simulated");
  }
  return std::move(volume);
}

// The pattern of the first volume. The rays' own number comes first; the others are what is left
// when no ray has one.
void VolumeAssembler::ChoosePattern()
{
  if (!volume.cuts.empty())
  {
    volume.coveragePatternNumber = volume.cuts.front().patternNumber;
    volume.coveragePattern = volume.cuts.front().pattern;
  }
  if (!volume.coveragePattern && !patterns.empty())
  {
    volume.coveragePattern = patterns.front();
  }
  const auto isOfRadar = [this](const RadarStatus& status)
  { return status.coveragePatternNumber == volume.coveragePatternNumber; };
  const auto own = std::find_if(statuses.rbegin(), statuses.rend(), isOfRadar);
  if (!statuses.empty())
  {
    volume.status = own != statuses.rend() ? *own : statuses.back();
  }
  if (!volume.coveragePatternNumber && volume.coveragePattern)
  {
    volume.coveragePatternNumber = volume.coveragePattern->number;
  }
  if (!volume.coveragePatternNumber && volume.status && volume.status->coveragePatternNumber > 0)
  {
    volume.coveragePatternNumber = volume.status->coveragePatternNumber;
  }
}

} // namespace nexrad
