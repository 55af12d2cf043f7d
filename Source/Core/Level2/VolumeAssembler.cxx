// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Level2/VolumeAssembler.h"

#include "nexrad/Level2/MomentChecks.h"
#include "nexrad/Level2/RayTimes.h"
#include "nexrad/Level2/SiteResolution.h"
#include "nexrad/Model/StrayRays.h"
#include "nexrad/Model/SweepWaveforms.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace nexrad
{

namespace
{

// Twenty times as many as any volume has. Without a limit a few compressed megabytes of empty rays
// would fill the memory.
constexpr std::size_t mostRays = 300'000;
// Thirty times as many as any file has. Each may be a cycle of its own, and so a volume.
constexpr std::size_t mostSweeps = 2'000;
constexpr double longestTurn = 400.0; // degrees in one sweep
constexpr std::uint8_t startOfCut = 0;
constexpr std::uint8_t startOfVolume = 3;
constexpr std::uint8_t endOfVolume = 4;
constexpr std::uint8_t startOfLastCut = 5;

bool StartsCut(const Ray& ray)
{
  return ray.radialStatus == startOfCut || ray.radialStatus == startOfVolume ||
         ray.radialStatus == startOfLastCut;
}

bool HasData(const Ray& ray)
{
  for (const MomentRow& row : ray.moments)
  {
    if (row.gates > 0)
    {
      return true;
    }
  }
  return false;
}

} // namespace

VolumeAssembler::VolumeAssembler(Level2Options readOptions)
  : options(std::move(readOptions))
{
}

void VolumeAssembler::BeginPiece(const std::string& name)
{
  piece = name + ": ";
  pieces.push_back(piece);
}

void VolumeAssembler::AddHeader(const VolumeHeader& header)
{
  hasHeader = true;
  headerName = header.siteName;
  volume.headerTime = header.time;
}

void VolumeAssembler::AddPattern(CoveragePattern pattern)
{
  // A file of several cycles has one each; the first belongs to the first rays.
  if (!volume.coveragePattern)
  {
    volume.coveragePattern = std::move(pattern);
  }
}

void VolumeAssembler::AddBuffer(std::shared_ptr<const std::vector<std::uint8_t>> buffer)
{
  volume.buffers.push_back(std::move(buffer));
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
  if (rayCount == mostRays)
  {
    this->AddDamage(offset, "more than " + std::to_string(mostRays) + " rays; the rest is left");
    return;
  }
  if (this->BeginsSweep(decoded.ray))
  {
    if (volume.sweeps.size() == mostSweeps)
    {
      this->AddDamage(
        offset, "more than " + std::to_string(mostSweeps) + " sweeps; the rest is left");
      return;
    }
    this->FinishSweep(&decoded.ray);
    volume.sweeps.emplace_back();
    places.emplace_back();
    volume.sweeps.back().elevationNumber = decoded.ray.elevationNumber;
    watch.Begin();
  }
  const bool allThere = watch.Missing() == 0;
  watch.Add(decoded, offset);
  missingPiece = allThere ? piece : missingPiece;
  lastRayPiece = piece;
  volume.complete = volume.complete || decoded.ray.radialStatus == endOfVolume;
  if (!volume.coveragePatternNumber && decoded.coveragePatternNumber > 0)
  {
    volume.coveragePatternNumber = decoded.coveragePatternNumber;
  }
  rayName = rayName.empty() ? decoded.siteName : rayName;
  if (decoded.position)
  {
    position.Add(*decoded.position, offset, pieces.size() - 1);
  }
  volume.messageType = std::max(volume.messageType.value_or(0), messageType);
  volume.sweeps.back().rays.push_back(decoded.ray);
  places.back().push_back({offset, pieces.size() - 1});
  ++rayCount;
}

bool VolumeAssembler::BeginsSweep(const Ray& ray)
{
  return volume.sweeps.empty() || volume.sweeps.back().elevationNumber != ray.elevationNumber ||
         StartsCut(ray) || std::abs(watch.TurnTo(ray.azimuth)) > longestTurn;
}

// Says what is missing in the sweep that ends here. `next` is the first ray of the next sweep, or
// nullptr at the end of the volume.
void VolumeAssembler::FinishSweep(const Ray* next)
{
  if (volume.sweeps.empty())
  {
    return;
  }
  const std::size_t index = volume.sweeps.size() - 1;
  const Sweep& sweep = volume.sweeps.back();
  if (watch.Missing() > 0)
  {
    damage.Add(watch.MissingOffset(), missingPiece + watch.Describe(index, sweep.elevationNumber));
  }
  if (next == nullptr || !watch.IsCutOff())
  {
    return;
  }
  const std::string cut = "sweep " + std::to_string(index) + " (elevation number " +
                          std::to_string(sweep.elevationNumber) + ")";
  // The radar may break a cut off and scan it again; then nothing was lost.
  if (next->elevationNumber == sweep.elevationNumber && StartsCut(*next))
  {
    volume.notes.push_back(cut + " was interrupted and restarted");
  }
  else
  {
    damage.Add(watch.LastOffset(), lastRayPiece + "rays missing at the end of " + cut);
  }
}

void VolumeAssembler::AddDamage(std::uint64_t offset, const std::string& what)
{
  damage.Add(offset, piece + what);
}

// What shows only beside the other rays.
void VolumeAssembler::CheckRays()
{
  const auto report = [this](std::size_t sweep, std::size_t ray, const std::string& what)
  {
    const RayPlace& place = places[sweep][ray];
    damage.Add(place.offset, pieces[place.piece] + what);
  };
  RemoveStrayCodings(volume, report);
  CutWideRows(volume, report);
  MendRayTimes(volume, report);
}

void VolumeAssembler::CheckPosition()
{
  const PositionVote::Group others = position.Others();
  if (others.rays > 0)
  {
    damage.Add(others.offset,
      pieces[others.piece] + std::to_string(others.rays) + " of " + std::to_string(rayCount) +
        " rays state another position of the radar than most do: that of most is used");
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

// What is missing at the end, after the other damage, so that it is there however much that is. The
// archive has files that hold metadata alone, beside those of the volumes.
void VolumeAssembler::CheckEnd(std::uint64_t size)
{
  if (!volume.sweeps.empty())
  {
    if (!volume.complete)
    {
      volume.damage.push_back({size, piece + "no end of volume: its last rays are missing"});
    }
    return;
  }
  if (hasHeader && piece.empty() && volume.damage.empty() && !metadata.empty())
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
  volume.damage.push_back({size, piece + what});
}

RadarVolume VolumeAssembler::Finish(const std::string& name, std::uint64_t size)
{
  volume.file = name;
  this->FinishSweep(nullptr);
  this->CheckRays();
  this->CheckPosition();
  volume.damage = damage.Take(piece.empty());
  this->CheckEnd(size);
  this->ChoosePattern();
  ResolveSite({headerName, rayName, name, position.Winner()}, options, volume);
  ResolveWaveforms(volume);
  this->NoteTimes();
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

// The rays' own number came first; these are what is left when no ray has one.
void VolumeAssembler::ChoosePattern()
{
  if (!volume.coveragePatternNumber)
  {
    if (volume.coveragePattern)
    {
      volume.coveragePatternNumber = volume.coveragePattern->number;
    }
    else if (volume.status && volume.status->coveragePatternNumber > 0)
    {
      volume.coveragePatternNumber = volume.status->coveragePatternNumber;
    }
  }
}

} // namespace nexrad
