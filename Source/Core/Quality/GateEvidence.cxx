// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Quality/GateEvidence.h"

#include <algorithm>
#include <cmath>

namespace nexrad
{

namespace
{

constexpr float smallDifference = 3.0F; // dB
constexpr float weakest = -5.0F;        // dBZ that a tilt without echo counts as

float Mean(float sum, float count)
{
  return count > 0.5F ? sum / count : NoNumber;
}

float Spread(float squares, float count)
{
  return count > 0.5F ? std::sqrt(std::max(0.5F * squares / count, 0.0F)) : NoNumber;
}

void Evaluate(const GateSums& sums, const GateSums& own, std::size_t i, EvidenceRow& evidence)
{
  const float pairs = At(sums, SumOf::Pairs);
  evidence.squares[i] = Mean(At(sums, SumOf::Squares), pairs);
  evidence.turns[i] = Mean(At(sums, SumOf::Turns), pairs);
  const float velocities = At(sums, SumOf::Velocities);
  evidence.still[i] = Mean(At(sums, SumOf::Still), velocities);
  evidence.speed[i] = Mean(At(sums, SumOf::Speed), velocities);
  evidence.width[i] = Mean(At(sums, SumOf::Width), velocities);
  evidence.ownStill[i] = Mean(At(own, SumOf::Still), At(own, SumOf::Velocities));
  evidence.ownSpeed[i] = Mean(At(own, SumOf::Speed), At(own, SumOf::Velocities));
  evidence.flow[i] = std::abs(At(sums, SumOf::Velocity)) / std::max(At(sums, SumOf::Speed), 0.1F);
}

void EvaluatePolarimetry(
  const GateSums& sums, const GateSums& own, std::size_t i, EvidenceRow& evidence)
{
  const float correlations = At(sums, PolarimetricSumOf::Correlations);
  evidence.correlation[i] = Mean(At(sums, PolarimetricSumOf::Correlation), correlations);
  evidence.ratio[i] = Mean(At(sums, PolarimetricSumOf::Ratio), correlations);
  evidence.ownCorrelation[i] =
    Mean(At(own, PolarimetricSumOf::Correlation), At(own, PolarimetricSumOf::Correlations));
  const float ratioPairs = At(sums, PolarimetricSumOf::RatioPairs);
  evidence.ratioSpread[i] = Spread(At(sums, PolarimetricSumOf::RatioSquares), ratioPairs);
  evidence.phaseSpread[i] = Spread(At(sums, PolarimetricSumOf::PhaseSquares), ratioPairs);
}

// Adds the windows about the gates of a range; the first window of the row is about `begin`.
void AddWindows(
  const RowSums& row, std::size_t begin, const GateRange& range, std::vector<GateSums>& sums)
{
  const std::size_t end = std::min(range.end, begin + row.windows.size());
  for (std::size_t gate = std::max(range.begin, begin); gate < end; ++gate)
  {
    for (std::size_t which = 0; which < SumCount; ++which)
    {
      sums[gate - range.begin][which] += row.windows[gate - begin][which];
    }
  }
}

// Counts the gates of a row that lie `offset` gates behind each of another one, `own`, and those
// that are alike, for the gates of a range. Of the row the gates of `counted` count.
void CountAlike(const float* own, const float* row, std::ptrdiff_t offset, const GateRange& range,
  const GateRange& counted, std::vector<float>& about, std::vector<float>& like)
{
  const auto first = static_cast<std::ptrdiff_t>(range.begin);
  const std::ptrdiff_t begin = std::max(first, static_cast<std::ptrdiff_t>(counted.begin) - offset);
  const std::ptrdiff_t end = std::min(
    static_cast<std::ptrdiff_t>(range.end), static_cast<std::ptrdiff_t>(counted.end) - offset);
  float* abouts = about.data();
  float* likes = like.data();
  for (std::ptrdiff_t i = begin; i < end; ++i)
  {
    const float other = row[i + offset];
    abouts[i - first] += IsNumber(other) ? 1.0F : 0.0F;
    likes[i - first] += std::abs(other - own[i]) < smallDifference ? 1.0F : 0.0F;
  }
}

} // namespace

void EvidenceRow::Clear()
{
  for (std::vector<float>* always : {&reflectivity, &range, &agreement, &squares, &turns, &still,
         &ownStill, &speed, &ownSpeed, &flow, &width})
  {
    always->resize(gates.size());
  }
  for (std::vector<float>* sometimes :
    {&correlation, &ownCorrelation, &ratio, &ratioSpread, &phaseSpread, &filterPower, &gradient})
  {
    sometimes->assign(gates.size(), NoNumber);
  }
}

EvidenceReader::EvidenceReader(const EchoGrid& theGrid, const EchoGrid* theAbove,
  const SweepSources& theSources, std::size_t gates, const std::vector<GateRange>& theWanted)
  : grid(theGrid)
  , above(theAbove)
  , sources(theSources)
  , geometry{gates, theGrid.RangeOf(0), theGrid.GateSpacing()}
  , wanted(theWanted)
{
  for (RowTextures& each : kept)
  {
    each.place = grid.Rays();
  }
}

// Gates of a row, from the first, that count.
std::size_t EvidenceReader::Counted(std::size_t place) const
{
  return std::min(geometry.gates, grid.Held(place).end);
}

// The gates of a row that windows about wanted gates of it and of its neighbours hold, and one more
// at either end, with which the outermost are compared.
GateRange EvidenceReader::SummedGates(std::size_t place) const
{
  GateRange all = wanted[place];
  for (const int step : {-1, 1})
  {
    const std::size_t beside = grid.Beside(place, step);
    all = beside < grid.Rays() ? Hull(all, wanted[beside]) : all;
  }
  const std::size_t margin = geometry.HalfWindow() + 1;
  return {all.begin - std::min(margin, all.begin), std::min(all.end + margin, Counted(place))};
}

const EvidenceReader::RowTextures& EvidenceReader::TexturesOf(std::size_t place)
{
  for (const RowTextures& each : kept)
  {
    if (each.place == place)
    {
      return each;
    }
  }
  RowTextures& row = kept[next];
  next = (next + 1) % kept.size();
  const GateRange summed = this->SummedGates(place);
  row.place = place;
  row.begin = summed.begin;
  RowGeometry part = geometry;
  part.gates = summed.Size();
  part.firstGate = grid.RangeOf(summed.begin);
  values.resize(part.gates);
  grid.Read(place, {summed.begin, summed.begin + part.gates}, values.data());
  row.textures.Set(values.data(), sources, grid.RayAt(place), part);
  return row;
}

void EvidenceReader::Read(std::size_t place, EvidenceRow& evidence)
{
  const float* row = grid.Row(place);
  const GateRange range = Common(wanted[place], {grid.Held(place).begin, this->Counted(place)});
  evidence.gates.clear();
  for (std::size_t gate = range.begin; gate < range.end; ++gate)
  {
    if (IsNumber(row[gate]))
    {
      evidence.gates.push_back(gate);
    }
  }
  evidence.Clear();
  if (evidence.gates.empty())
  {
    return;
  }
  evidence.elevation = static_cast<float>(grid.Elevation());
  for (std::size_t i = 0; i < evidence.gates.size(); ++i)
  {
    evidence.reflectivity[i] = row[evidence.gates[i]];
    evidence.range[i] = static_cast<float>(grid.RangeOf(evidence.gates[i]));
  }
  this->ReadTextures(place, range, evidence);
  this->ReadAgreement(place, range, evidence);
  this->ReadGradient(place, evidence);
  this->ReadFilterPower(place, evidence);
}

void EvidenceReader::ReadTextures(std::size_t place, const GateRange& range, EvidenceRow& evidence)
{
  sums.assign(range.end - range.begin, GateSums{});
  polarimetricSums.clear();
  for (const std::size_t each : {grid.Beside(place, -1), place, grid.Beside(place, 1)})
  {
    if (each < grid.Rays())
    {
      const RowTextures& row = this->TexturesOf(each);
      AddWindows(row.textures.Sums(), row.begin, range, sums);
      if (!row.textures.PolarimetricSums().own.empty())
      {
        polarimetricSums.resize(range.end - range.begin);
        AddWindows(row.textures.PolarimetricSums(), row.begin, range, polarimetricSums);
      }
    }
  }
  const RowTextures& own = this->TexturesOf(place);
  for (std::size_t i = 0; i < evidence.gates.size(); ++i)
  {
    const std::size_t gate = evidence.gates[i];
    Evaluate(sums[gate - range.begin], own.textures.Sums().own[gate - own.begin], i, evidence);
  }
  const std::vector<GateSums>& polarimetric = own.textures.PolarimetricSums().own;
  for (std::size_t i = 0; i < evidence.gates.size() && !polarimetricSums.empty(); ++i)
  {
    const std::size_t gate = evidence.gates[i];
    EvaluatePolarimetry(polarimetricSums[gate - range.begin],
      polarimetric.empty() ? GateSums{} : polarimetric[gate - own.begin], i, evidence);
  }
}

void EvidenceReader::ReadAgreement(std::size_t place, const GateRange& range, EvidenceRow& evidence)
{
  const float* own = grid.Row(place);
  const auto far = static_cast<std::ptrdiff_t>(geometry.HalfWindow());
  about.assign(range.end - range.begin, 0.0F);
  like.assign(range.end - range.begin, 0.0F);
  for (const std::size_t each : {grid.Beside(place, -1), place, grid.Beside(place, 1)})
  {
    const GateRange counted = Common(grid.Held(each), {0, this->Counted(place)});
    for (const std::ptrdiff_t offset :
      {-far, far, std::ptrdiff_t(-1), std::ptrdiff_t(0), std::ptrdiff_t(1)})
    {
      CountAlike(own, grid.Row(each), offset, range, counted, about, like);
    }
  }
  for (std::size_t i = 0; i < evidence.gates.size(); ++i)
  {
    const std::size_t at = evidence.gates[i] - range.begin;
    const float all = about[at] - 1.0F; // the gate itself is one of them
    evidence.agreement[i] = all > 2.5F ? (like[at] - 1.0F) / all : NoNumber;
  }
}

void EvidenceReader::ReadGradient(std::size_t place, EvidenceRow& evidence) const
{
  const std::size_t beyond = above ? above->PlaceAt(grid.AzimuthAt(place)) : 0;
  if (above == nullptr || beyond == above->Rays())
  {
    return;
  }
  const auto perDegree = static_cast<float>(1.0 / (above->Elevation() - grid.Elevation()));
  const double step = grid.GateSpacing() / above->GateSpacing();
  const double from = (grid.RangeOf(0) - above->RangeOf(0)) / above->GateSpacing() + 0.5;
  for (std::size_t i = 0; i < evidence.gates.size(); ++i)
  {
    const double at = from + step * static_cast<double>(evidence.gates[i]);
    if (at >= 0.0 && at < static_cast<double>(above->Gates()))
    {
      const float value = evidence.reflectivity[i];
      const float upper = above->At(beyond, static_cast<std::size_t>(at));
      const float over = std::max(upper, std::min(weakest, value));
      evidence.gradient[i] = (value - over) * perDegree;
    }
  }
}

void EvidenceReader::ReadFilterPower(std::size_t place, EvidenceRow& evidence)
{
  const std::size_t ray = grid.RayAt(place);
  if (!sources.filterPower.Has(ray))
  {
    return;
  }
  ReadMoment(sources.filterPower, ray, geometry, codes, filterPower);
  for (std::size_t i = 0; i < evidence.gates.size(); ++i)
  {
    evidence.filterPower[i] = filterPower[evidence.gates[i]];
  }
}

} // namespace nexrad
