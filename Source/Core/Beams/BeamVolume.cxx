// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Beams/BeamVolume.h"

#include "nexrad/Geometry/Angles.h"
#include "nexrad/Model/Elevation.h"
#include "nexrad/Model/SiteTable.h"
#include "nexrad/Polar/SweepPairing.h"
#include "nexrad/System/Error.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace nexrad
{

namespace
{

// A ray's place in the sweep and its azimuth, 0…360.
struct SortedRay
{
  double azimuth;
  std::size_t ray;
};

std::vector<SortedRay> SortRays(const PolarSweep& sweep, const std::vector<std::size_t>& rays)
{
  constexpr double sameAzimuth = 1e-3; // degrees
  std::vector<SortedRay> sorted;
  for (const std::size_t i : rays)
  {
    sorted.push_back({ToFullTurn(static_cast<double>(sweep.rays[i].azimuth)), i});
  }
  // Of two rays in one direction the later comes first, and stays.
  const auto before = [&sweep](const SortedRay& a, const SortedRay& b)
  {
    return a.azimuth != b.azimuth ? a.azimuth < b.azimuth
                                  : sweep.rays[a.ray].time > sweep.rays[b.ray].time;
  };
  std::sort(sorted.begin(), sorted.end(), before);
  const auto same = [](const SortedRay& a, const SortedRay& b)
  { return b.azimuth - a.azimuth < sameAzimuth; };
  sorted.erase(std::unique(sorted.begin(), sorted.end(), same), sorted.end());
  return sorted;
}

// Rays and what of them stands before the first and after the last.
std::vector<SortedRay> CloseTheCircle(const std::vector<SortedRay>& rays)
{
  std::vector<SortedRay> entries = {{rays.back().azimuth - 360.0, rays.back().ray}};
  entries.insert(entries.end(), rays.begin(), rays.end());
  entries.push_back({rays.front().azimuth + 360.0, rays.front().ray});
  return entries;
}

double MedianGap(const std::vector<SortedRay>& entries)
{
  std::vector<double> gaps;
  for (std::size_t i = 0; i + 1 < entries.size(); ++i)
  {
    gaps.push_back(entries[i + 1].azimuth - entries[i].azimuth);
  }
  return MedianOf(std::move(gaps));
}

void SetDirections(
  const PolarSweep& source, const std::vector<SortedRay>& entries, double beamWidth, BeamSweep& to)
{
  // A sweep of one ray has no spacing of its own.
  const double spacing = std::max(beamWidth, std::min(MedianGap(entries), 2.0));
  const double widest = 1.5 * spacing;
  to.halfWidth = static_cast<float>(0.5 * spacing);
  for (std::size_t i = 0; i < entries.size(); ++i)
  {
    to.azimuths.push_back(static_cast<float>(entries[i].azimuth));
    const PolarRay& ray = source.rays[entries[i].ray];
    to.elevations.push_back(ray.elevation);
    const Duration since = ray.time - to.begin;
    to.times.push_back(static_cast<float>(since.count()) / 1000.0F);
    const double gap =
      i + 1 < entries.size() ? entries[i + 1].azimuth - entries[i].azimuth : 2.0 * widest;
    to.inverseGaps.push_back(gap <= widest ? static_cast<float>(1.0 / gap) : 0.0F);
  }
  std::uint32_t entry = 0;
  const int bins = static_cast<int>(360.0F * BeamSweep::BinsPerDegree);
  for (int bin = 0; bin < bins; ++bin)
  {
    const float start = static_cast<float>(bin) / BeamSweep::BinsPerDegree;
    while (to.azimuths[entry + 1U] <= start)
    {
      ++entry;
    }
    to.firstEntries.push_back(entry);
  }
}

void SetCodes(const PolarSweep& source, const std::vector<SortedRay>& entries, BeamSweep& to)
{
  to.scale = source.scale;
  std::size_t stored = 0;
  for (const SortedRay& entry : entries)
  {
    to.held.push_back(source.rows.Held(entry.ray, source.gates));
    stored = std::max(stored, to.held.back().end);
  }
  to.storedGates = static_cast<int>(stored);
  const std::shared_ptr<std::uint16_t[]> codes(new std::uint16_t[to.CodeCount()]);
  const std::size_t read = std::min(to.Stride(), source.gates);
  std::uint16_t* row = codes.get();
  for (const SortedRay& entry : entries)
  {
    source.rows.Read(entry.ray, read, row);
    row[stored] = row[read - 1];
    row += to.Stride();
  }
  to.codes = codes;
}

bool IsComplete(const BeamSweep& sweep)
{
  if (!sweep.IsClosed())
  {
    return false;
  }
  for (std::size_t entry = 0; entry < sweep.held.size(); ++entry)
  {
    const std::uint16_t* codes = sweep.Row(entry);
    const GateRange& held = sweep.held[entry];
    const std::uint16_t* end = codes + held.end;
    if (std::find(codes + held.begin, end, GateCode::NotSampled) != end)
    {
      return false;
    }
  }
  return true;
}

// A sweep of some of the rays of `source`.
BeamSweep PrepareSweep(
  const PolarSweep& source, const std::vector<std::size_t>& rays, double beamWidth)
{
  BeamSweep sweep;
  const double elevation = MedianElevation(source);
  sweep.elevation = static_cast<float>(elevation);
  sweep.sine = static_cast<float>(std::sin(elevation * RadiansPerDegree));
  sweep.cosine = static_cast<float>(std::cos(elevation * RadiansPerDegree));
  sweep.firstGate = static_cast<float>(source.firstGate);
  sweep.gatesPerMetre = static_cast<float>(1.0 / source.gateSpacing);
  sweep.gates = static_cast<int>(source.gates);
  const auto earlier = [&source](std::size_t a, std::size_t b)
  { return source.rays[a].time < source.rays[b].time; };
  const auto times = std::minmax_element(rays.begin(), rays.end(), earlier);
  sweep.begin = source.rays[*times.first].time;
  sweep.end = source.rays[*times.second].time;
  const std::vector<SortedRay> entries = CloseTheCircle(SortRays(source, rays));
  SetDirections(source, entries, beamWidth, sweep);
  SetCodes(source, entries, sweep);
  sweep.complete = IsComplete(sweep);
  return sweep;
}

constexpr float notScanned = -1.0F;
constexpr int longestRun = 1 << 23; // a float still counts in ones

float ValueOf(const VolumeComposite& composite, std::size_t cell)
{
  return composite.cells[cell] == VolumeComposite::Cell::NotScanned ? notScanned
                                                                    : composite.values[cell];
}

PackedComposite Pack(const VolumeComposite& composite)
{
  PackedComposite packed{composite.rings, composite.echoTime, composite.echo, composite.tilts, {}};
  const std::size_t count = composite.cells.size();
  for (std::size_t cell = 0; cell < count;)
  {
    const float value = ValueOf(composite, cell);
    int run = 1;
    while (run < longestRun && cell + static_cast<std::size_t>(run) < count &&
           ValueOf(composite, cell + static_cast<std::size_t>(run)) == value)
    {
      ++run;
    }
    if (run > 1)
    {
      packed.picture.push_back(-static_cast<float>(run));
    }
    packed.picture.push_back(value);
    cell += static_cast<std::size_t>(run);
  }
  return packed;
}

} // namespace

std::size_t BeamVolume::MemoryBytes() const
{
  std::size_t bytes = sizeof(BeamVolume) + composite.MemoryBytes() + lowest.MemoryBytes();
  bytes += layers->MemoryBytes();
  for (const BeamSweep& sweep : sweeps)
  {
    bytes += sizeof(BeamSweep) + 4 * sweep.azimuths.size() * sizeof(float) +
             sweep.firstEntries.size() * sizeof(std::uint32_t) +
             sweep.CodeCount() * sizeof(std::uint16_t) + sweep.held.size() * sizeof(GateRange) +
             sweep.means.MemoryBytes();
  }
  return bytes;
}

BeamVolume PrepareBeamVolume(const PolarVolume& volume, std::optional<double> beamWidth)
{
  const double width = beamWidth.value_or(BeamWidthOf(volume.site));
  BeamVolume prepared;
  prepared.site = volume.site;
  prepared.moment = volume.moment;
  prepared.start = volume.start;
  prepared.end = volume.end;
  prepared.synthetic = volume.synthetic;
  prepared.echo = volume.echo;
  prepared.endsAt = volume.endsAt;
  for (std::size_t i = 0; i < volume.sweeps.size(); ++i)
  {
    const PolarSweep& sweep = volume.sweeps[i];
    const double end =
      sweep.firstGate + (static_cast<double>(sweep.gates) - 0.5) * sweep.gateSpacing; // m
    if (sweep.rays.empty() || sweep.gates == 0 || !(sweep.gateSpacing > 0.0) || !(end > 0.0))
    {
      continue;
    }
    std::vector<std::size_t> rays = FindRaysOfCut(sweep, width);
    const bool strays = rays.size() < sweep.rays.size();
    LeaveOutSeenTwice(volume, i, width, rays);
    if (!rays.empty())
    {
      prepared.sweeps.push_back(PrepareSweep(sweep, rays, width));
      prepared.sweeps.back().strays = strays;
    }
  }
  prepared.composite = MakeComposite(prepared.sweeps);
  if (prepared.moment == MomentName::REF)
  {
    prepared.lowest = MakeLowestComposite(prepared.sweeps);
  }
  return prepared;
}

std::size_t VolumeSummary::MemoryBytes() const
{
  std::size_t bytes = sizeof(*this);
  for (const PackedComposite* packed : {&composite, &lowest})
  {
    bytes +=
      packed->picture.size() * sizeof(float) + packed->tilts.size() * sizeof(VolumeComposite::Tilt);
  }
  return bytes;
}

VolumeSummary MakeSummary(const BeamVolume& volume)
{
  VolumeSummary summary;
  if (volume.moment == MomentName::REF)
  {
    summary.composite = Pack(volume.composite);
    summary.lowest = Pack(volume.lowest);
  }
  for (const BeamSweep& sweep : volume.sweeps)
  {
    summary.reach = std::max(summary.reach, static_cast<double>(sweep.Reach()));
  }
  return summary;
}

VolumeSummary MakeSummary(const PolarVolume& volume)
{
  VolumeSummary summary;
  if (volume.moment == MomentName::REF)
  {
    summary = MakeSummary(PrepareBeamVolume(volume));
  }
  for (const PolarSweep& sweep : volume.sweeps)
  {
    summary.reach = std::max(
      summary.reach, sweep.firstGate + static_cast<double>(sweep.gates) * sweep.gateSpacing);
  }
  return summary;
}

VolumeComposite CompositeOf(const PackedComposite& packed)
{
  VolumeComposite composite;
  composite.rings = packed.rings;
  composite.echoTime = packed.echoTime;
  composite.echo = packed.echo;
  composite.tilts = packed.tilts;
  const std::size_t size = composite.Index(VolumeComposite::Sectors, 0);
  composite.cells.assign(size, VolumeComposite::Cell::NotScanned);
  composite.tops.assign(size, 0);
  composite.values.assign(size, 0.0F);
  std::size_t next = 0;  // cell
  std::size_t count = 1; // of cells that the next value stands for
  for (const float word : packed.picture)
  {
    if (word <= -2.0F)
    {
      count = static_cast<std::size_t>(-word);
      continue;
    }
    if (count > size - next)
    {
      throw Error("the picture of a volume has more cells than its rings");
    }
    const auto cell = word < 0.0F   ? VolumeComposite::Cell::NotScanned
                      : word > 0.0F ? VolumeComposite::Cell::Held
                                    : VolumeComposite::Cell::NoEcho;
    std::fill_n(&composite.cells[next], count, cell);
    std::fill_n(&composite.values[next], count, std::max(0.0F, word));
    next += count;
    count = 1;
  }
  if (next != size)
  {
    throw Error("the picture of a volume has fewer cells than its rings");
  }
  return composite;
}

} // namespace nexrad
