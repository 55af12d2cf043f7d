// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Polar/PolarVolume.h"

#include "nexrad/Model/Elevation.h"
#include "nexrad/Model/MomentLimits.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace nexrad
{

namespace
{

using RayList = std::vector<const Ray*>;
using RowList = std::vector<MomentRow>;

// Files have two states before the first word of a value.
constexpr std::uint16_t codesBeforeWords = GateCode::FirstValue - 2;

std::uint16_t CodeOf(GateState state)
{
  switch (state)
  {
  case GateState::BelowThreshold:
    return GateCode::NoEcho;
  case GateState::RangeFolded:
    return GateCode::RangeFolded;
  default:
    return GateCode::NotSampled;
  }
}

// How the words of the rays of a sweep become codes.
struct Coding
{
  GateScale scale;
  std::uint16_t largest = 0; // code
  bool exact = false;        // the code of a value is its word + codesBeforeWords
};

unsigned LargestWord(const MomentRow& row)
{
  if (row.wordBits == 8)
  {
    std::uint8_t largest = 0;
    for (std::size_t gate = 0; gate < row.gates; ++gate)
    {
      largest = std::max(largest, row.words[gate]);
    }
    return largest;
  }
  unsigned largest = 0;
  for (std::size_t gate = 0; gate < row.gates; ++gate)
  {
    largest = std::max(largest, row.Raw(gate));
  }
  return largest;
}

// The words' own scale; not exact where the rays have none in common that codes can have. The
// largest code is that of the rows, or with `any` of all words as long as theirs.
Coding FindWordCoding(const RowList& rows, bool any)
{
  constexpr unsigned largestWord = GateCode::Last - codesBeforeWords;
  const MomentRow& first = rows.front();
  Coding coding{{(-1.0F - first.offset) / first.scale, 1.0F / first.scale}, 0, true};
  unsigned largest = 0;
  for (const MomentRow& row : rows)
  {
    coding.exact = coding.exact && row.scale == first.scale && row.offset == first.offset &&
                   row.firstValue == first.firstValue;
    largest = std::max(largest, any && row.wordBits == 8 ? 255U : LargestWord(row));
  }
  coding.exact = coding.exact && largest <= largestWord && coding.scale.step > 0.0F &&
                 std::isfinite(coding.scale.step) && std::isfinite(coding.scale.base);
  coding.largest = static_cast<std::uint16_t>(std::min(largest, largestWord) + codesBeforeWords);
  return coding;
}

// The scale of values that are added one after the other.
class ValueRange
{
public:
  void Add(float value)
  {
    if (std::isfinite(value))
    {
      least = std::min(least, value);
      most = std::max(most, value);
    }
  }

  Coding MakeCoding() const
  {
    Coding coding;
    if (least <= most)
    {
      coding.scale = GateScale::Between(least, most);
      coding.largest = coding.scale.CodeOf(most);
    }
    return coding;
  }

private:
  float least = std::numeric_limits<float>::max();
  float most = std::numeric_limits<float>::lowest();
};

Coding FindValueCoding(const RowList& rows)
{
  ValueRange range;
  for (const MomentRow& row : rows)
  {
    for (std::size_t gate = 0; gate < row.gates; ++gate)
    {
      if (row.State(gate) == GateState::Valid)
      {
        range.Add(row.Value(gate));
      }
    }
  }
  return range.MakeCoding();
}

std::uint16_t CodeOf(float value, const GateScale& scale)
{
  return std::isfinite(value) ? scale.CodeOf(value) : GateCode::NotSampled;
}

// Every gate of every file passes here: the loops have no branch, and the compiler puts words side
// by side. The row's own number of gates could be the memory of a code.
template <class WordAt>
void SetWords(const MomentRow& row, const WordAt& wordAt, std::uint16_t* codes)
{
  const std::uint16_t first = row.firstValue;
  const std::size_t gates = row.gates;
  if (first == 2) // then words below the first value are the codes of their states
  {
    for (std::size_t gate = 0; gate < gates; ++gate)
    {
      codes[gate] = CodeOfWord(wordAt(gate));
    }
    return;
  }
  for (std::size_t gate = 0; gate < gates; ++gate)
  {
    const std::uint16_t word = wordAt(gate);
    codes[gate] =
      word >= first ? static_cast<std::uint16_t>(word + codesBeforeWords) : GateCode::NoEcho;
  }
}

void SetCodes(const MomentRow& row, const Coding& coding, std::uint16_t* codes)
{
  const std::uint8_t* words = row.words;
  if (!coding.exact)
  {
    for (std::size_t gate = 0; gate < row.gates; ++gate)
    {
      const GateState state = row.State(gate);
      codes[gate] =
        state == GateState::Valid ? CodeOf(row.Value(gate), coding.scale) : CodeOf(state);
    }
  }
  else if (row.wordBits == 8)
  {
    SetWords(
      row, [words](std::size_t gate) -> std::uint16_t { return words[gate]; }, codes);
  }
  else
  {
    SetWords(
      row, [&row](std::size_t gate) { return static_cast<std::uint16_t>(row.Raw(gate)); }, codes);
  }
}

// Of the gates of a sweep those whose centres lie within a slant range.
std::size_t GatesWithin(const PolarSweep& sweep, double range)
{
  const double last = std::floor((range - sweep.firstGate) / sweep.gateSpacing);
  return static_cast<std::size_t>(std::clamp(last + 1.0, 0.0, static_cast<double>(sweep.gates)));
}

// The rows of the rays, without the gates from `gates` on.
RowList RowsOf(const RayList& rays, MomentName moment, std::size_t gates)
{
  RowList rows;
  rows.reserve(rays.size());
  for (const Ray* ray : rays)
  {
    MomentRow row = ray->Row(moment);
    row.gates = static_cast<std::uint16_t>(std::min<std::size_t>(row.gates, gates));
    rows.push_back(row);
  }
  return rows;
}

// Whether the words of all rays can stay where they are (GateRows::AppendWords).
bool CanStay(const RayList& rays, const RowList& rows, MomentName moment, const Coding& coding)
{
  for (std::size_t i = 0; i < rays.size(); ++i)
  {
    if (rows[i].wordBits != 8 || rows[i].firstValue != 2 ||
        !ImpossibleGates(*rays[i], moment, rows[i].gates).empty())
    {
      return false;
    }
  }
  return coding.exact;
}

PolarSweep MakeSweep(
  const RayList& rays, Waveform waveform, MomentName moment, const WantedRange& wanted)
{
  PolarSweep sweep;
  sweep.waveform = waveform;
  const MomentRow& first = rays.front()->Row(moment);
  sweep.elevationNumber = rays.front()->elevationNumber;
  sweep.firstGate = first.firstGate;
  sweep.gateSpacing = first.gateSpacing;
  sweep.rays.reserve(rays.size());
  for (const Ray* ray : rays)
  {
    sweep.gates = std::max<std::size_t>(sweep.gates, ray->Row(moment).gates);
    sweep.rays.push_back(
      {ray->azimuth, ray->elevation, ray->unambiguousRange, ray->time, ray->nyquist});
  }
  if (wanted && sweep.gateSpacing > 0.0)
  {
    sweep.gates = std::max<std::size_t>(1, GatesWithin(sweep, wanted(MedianElevation(sweep))));
  }
  const RowList rows = RowsOf(rays, moment, sweep.gates);
  Coding coding = FindWordCoding(rows, static_cast<bool>(wanted));
  if (!coding.exact)
  {
    coding = FindValueCoding(rows);
  }
  sweep.scale = coding.scale;
  sweep.rows = GateRows(coding.largest);
  if (wanted && CanStay(rays, rows, moment, coding))
  {
    for (const MomentRow& row : rows)
    {
      sweep.rows.AppendWords(row.words, row.gates);
    }
    return sweep;
  }
  std::vector<std::uint16_t> codes(sweep.gates);
  for (std::size_t i = 0; i < rays.size(); ++i)
  {
    SetCodes(rows[i], coding, codes.data());
    std::fill(codes.begin() + rows[i].gates, codes.end(), GateCode::NotSampled);
    for (const std::size_t gate : ImpossibleGates(*rays[i], moment, sweep.gates))
    {
      codes[gate] = GateCode::NotSampled;
    }
    sweep.rows.Append(codes.data(), codes.size());
  }
  sweep.rows.Finish();
  return sweep;
}

// The first gate whose centre lies beyond the unambiguous range of a ray; all of them without one.
std::size_t GatesWithin(const PolarSweep& sweep, const PolarRay& ray)
{
  const auto range = static_cast<double>(ray.unambiguousRange);
  return range > 0.0 ? GatesWithin(sweep, range) : sweep.gates;
}

// The rays of a sweep that have a moment, by gate geometry, in the order in which each geometry
// comes first. Nearly always there is one.
std::vector<RayList> RaysByGeometry(const Sweep& sweep, MomentName moment)
{
  std::vector<RayList> groups;
  std::map<std::pair<std::int32_t, std::int32_t>, std::size_t> places;
  for (const Ray& ray : sweep.rays)
  {
    const MomentRow& row = ray.Row(moment);
    if (row.gates > 0)
    {
      const auto place = places.emplace(std::pair(row.firstGate, row.gateSpacing), groups.size());
      if (place.second)
      {
        groups.emplace_back();
      }
      groups[place.first->second].push_back(&ray);
    }
  }
  return groups;
}

// Degrees: the elevation of the last sweep of a volume whose last cuts are lost. An excerpt was cut
// off on purpose.
std::optional<double> WhereCutOff(const RadarVolume& volume)
{
  const bool lost = !volume.cuts.empty() && volume.cuts.back().end == VolumeEnd::Missing &&
                    !volume.cuts.back().excerpt && !volume.sweeps.empty() &&
                    !volume.sweeps.back().rays.empty();
  return lost ? std::optional(volume.sweeps.back().MedianElevation()) : std::nullopt;
}

} // namespace

GateState StateOf(std::uint16_t code)
{
  switch (code)
  {
  case GateCode::NoEcho:
    return GateState::BelowThreshold;
  case GateCode::RangeFolded:
    return GateState::RangeFolded;
  case GateCode::NotSampled:
  case GateCode::Filtered:
    return GateState::NotSampled;
  default:
    return GateState::Valid;
  }
}

void SetGates(
  PolarSweep& sweep, const std::vector<float>& values, const std::vector<GateState>& states)
{
  ValueRange range;
  for (std::size_t gate = 0; gate < values.size(); ++gate)
  {
    if (states[gate] == GateState::Valid)
    {
      range.Add(values[gate]);
    }
  }
  const Coding coding = range.MakeCoding();
  sweep.scale = coding.scale;
  sweep.rows = GateRows(coding.largest);
  std::vector<std::uint16_t> codes(sweep.gates);
  for (std::size_t ray = 0; ray < sweep.rays.size(); ++ray)
  {
    const std::size_t first = ray * sweep.gates;
    for (std::size_t gate = 0; gate < sweep.gates; ++gate)
    {
      const GateState state = states[first + gate];
      codes[gate] =
        state == GateState::Valid ? CodeOf(values[first + gate], coding.scale) : CodeOf(state);
    }
    sweep.rows.Append(codes.data(), codes.size());
  }
  sweep.rows.Finish();
}

void LimitReach(PolarSweep& sweep)
{
  if (sweep.waveform == Waveform::Batch || sweep.waveform == Waveform::Unknown ||
      !(sweep.gateSpacing > 0.0) ||
      std::all_of(sweep.rays.begin(), sweep.rays.end(),
        [&sweep](const PolarRay& ray) { return GatesWithin(sweep, ray) == sweep.gates; }))
  {
    return;
  }
  std::size_t sampled = 0;
  bool changed = false;
  GateRows limited(sweep.rows.LargestCode());
  std::vector<std::uint16_t> codes(sweep.gates);
  for (std::size_t ray = 0; ray < sweep.rays.size(); ++ray)
  {
    sweep.Read(ray, codes.data());
    const std::size_t within = GatesWithin(sweep, sweep.rays[ray]);
    sampled = std::max(sampled, within);
    for (std::size_t gate = within; gate < sweep.gates; ++gate)
    {
      changed = changed || codes[gate] == GateCode::NoEcho;
      codes[gate] = codes[gate] == GateCode::NoEcho ? GateCode::NotSampled : codes[gate];
      sampled = codes[gate] == GateCode::NotSampled ? sampled : std::max(sampled, gate + 1);
    }
    limited.Append(codes.data(), codes.size());
  }
  if (changed)
  {
    limited.Finish();
    sweep.rows = std::move(limited);
    sweep.gates = std::min(sweep.gates, sampled);
  }
}

std::size_t MemoryOf(const PolarVolume& volume)
{
  std::size_t bytes = sizeof(PolarVolume);
  for (const PolarSweep& sweep : volume.sweeps)
  {
    bytes +=
      sizeof(PolarSweep) + sweep.rays.capacity() * sizeof(PolarRay) + sweep.rows.MemoryBytes();
  }
  return bytes;
}

double MedianElevation(const PolarSweep& sweep)
{
  std::vector<double> elevations;
  for (const PolarRay& ray : sweep.rays)
  {
    elevations.push_back(static_cast<double>(ray.elevation));
  }
  return MedianOf(std::move(elevations));
}

PolarVolume MakePolarVolume(const RadarVolume& volume, MomentName moment, const WantedRange& wanted)
{
  PolarVolume polar;
  polar.site = volume.site;
  polar.moment = moment;
  polar.start = volume.Start().value_or(Time{});
  polar.end = volume.End().value_or(Time{});
  polar.synthetic = volume.synthetic;
  polar.endsAt = WhereCutOff(volume);
  for (const Sweep& sweep : volume.sweeps)
  {
    for (const RayList& rays : RaysByGeometry(sweep, moment))
    {
      polar.sweeps.push_back(MakeSweep(rays, sweep.waveform, moment, wanted));
      if (moment == MomentName::REF)
      {
        LimitReach(polar.sweeps.back());
      }
    }
  }
  return polar;
}

} // namespace nexrad
