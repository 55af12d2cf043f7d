// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Quality/Evidence/GateEvidence.h"

#include <algorithm>
#include <cmath>

namespace nexrad
{

namespace
{

constexpr float alike = 3.0F;    // dB
constexpr float weakest = -5.0F; // dBZ that a tilt without echo counts as

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

void AddWindows(const RowSums& row, std::vector<GateSums>& sums)
{
  for (std::size_t i = 0; i < std::min(sums.size(), row.windows.size()); ++i)
  {
    for (std::size_t which = 0; which < SumCount; ++which)
    {
      sums[i][which] += row.windows[i][which];
    }
  }
}

// Counts the gates of a row that lie `offset` gates behind each of another one, `own`, and those
// that are alike, of the first `about.size()` gates.
void CountAlike(const float* own, const float* row, std::ptrdiff_t offset,
  std::vector<float>& about, std::vector<float>& like)
{
  const auto count = static_cast<std::ptrdiff_t>(about.size());
  const std::ptrdiff_t end = count - std::max<std::ptrdiff_t>(offset, 0);
  float* abouts = about.data();
  float* likes = like.data();
  for (std::ptrdiff_t i = std::max<std::ptrdiff_t>(-offset, 0); i < end; ++i)
  {
    const float other = row[i + offset];
    abouts[i] += IsNumber(other) ? 1.0F : 0.0F;
    likes[i] += std::abs(other - own[i]) < alike ? 1.0F : 0.0F;
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
  const SweepSources& theSources, std::size_t gates)
  : grid(theGrid)
  , above(theAbove)
  , sources(theSources)
  , geometry{gates, theGrid.RangeOf(0), theGrid.GateSpacing()}
{
  for (RowTextures& each : kept)
  {
    each.place = grid.Rays();
  }
}

const RayTextures& EvidenceReader::TexturesOf(std::size_t place)
{
  for (const RowTextures& each : kept)
  {
    if (each.place == place)
    {
      return each.textures;
    }
  }
  RowTextures& row = kept[next];
  next = (next + 1) % kept.size();
  row.place = place;
  RowGeometry held = geometry;
  held.gates = std::min(geometry.gates, grid.Held(place).end);
  row.textures.Set(grid.Row(place), sources, grid.RayAt(place), held);
  return row.textures;
}

void EvidenceReader::Read(std::size_t place, EvidenceRow& evidence)
{
  const float* row = grid.Row(place);
  const GateRange held = grid.Held(place);
  evidence.gates.clear();
  for (std::size_t gate = held.begin; gate < std::min(geometry.gates, held.end); ++gate)
  {
    if (IsNumber(row[gate]))
    {
      evidence.gates.push_back(gate);
    }
  }
  evidence.Clear();
  evidence.elevation = static_cast<float>(grid.Elevation());
  for (std::size_t i = 0; i < evidence.gates.size(); ++i)
  {
    evidence.reflectivity[i] = row[evidence.gates[i]];
    evidence.range[i] = static_cast<float>(grid.RangeOf(evidence.gates[i]));
  }
  this->ReadTextures(place, evidence);
  this->ReadAgreement(place, evidence);
  this->ReadGradient(place, evidence);
  this->ReadFilterPower(place, evidence);
}

void EvidenceReader::ReadTextures(std::size_t place, EvidenceRow& evidence)
{
  const std::size_t gates = std::min(geometry.gates, grid.Held(place).end);
  sums.assign(gates, GateSums{});
  polarimetricSums.clear();
  for (const std::size_t each : {grid.Beside(place, -1), place, grid.Beside(place, 1)})
  {
    if (each < grid.Rays())
    {
      const RayTextures& textures = this->TexturesOf(each);
      AddWindows(textures.Sums(), sums);
      if (!textures.PolarimetricSums().own.empty())
      {
        polarimetricSums.resize(gates);
        AddWindows(textures.PolarimetricSums(), polarimetricSums);
      }
    }
  }
  const RayTextures& own = this->TexturesOf(place);
  for (std::size_t i = 0; i < evidence.gates.size(); ++i)
  {
    const std::size_t gate = evidence.gates[i];
    Evaluate(sums[gate], own.Sums().own[gate], i, evidence);
  }
  const std::vector<GateSums>& polarimetric = own.PolarimetricSums().own;
  for (std::size_t i = 0; i < evidence.gates.size() && !polarimetricSums.empty(); ++i)
  {
    const std::size_t gate = evidence.gates[i];
    EvaluatePolarimetry(
      polarimetricSums[gate], polarimetric.empty() ? GateSums{} : polarimetric[gate], i, evidence);
  }
}

void EvidenceReader::ReadAgreement(std::size_t place, EvidenceRow& evidence)
{
  const std::size_t count = std::min(geometry.gates, grid.Held(place).end);
  const float* own = grid.Row(place);
  const auto far = static_cast<std::ptrdiff_t>(geometry.HalfWindow());
  about.assign(count, 0.0F);
  like.assign(count, 0.0F);
  for (const float* row : {grid.RowBeside(place, -1), own, grid.RowBeside(place, 1)})
  {
    for (const std::ptrdiff_t offset :
      {-far, far, std::ptrdiff_t(-1), std::ptrdiff_t(0), std::ptrdiff_t(1)})
    {
      CountAlike(own, row, offset, about, like);
    }
  }
  for (std::size_t i = 0; i < evidence.gates.size(); ++i)
  {
    const float all = about[evidence.gates[i]] - 1.0F; // the gate itself is one of them
    evidence.agreement[i] = all > 2.5F ? (like[evidence.gates[i]] - 1.0F) / all : NoNumber;
  }
}

void EvidenceReader::ReadGradient(std::size_t place, EvidenceRow& evidence) const
{
  const std::size_t beyond = above ? above->PlaceAt(grid.AzimuthAt(place)) : 0;
  if (above == nullptr || beyond == above->Rays())
  {
    return;
  }
  const float* upper = above->Row(beyond);
  const auto perDegree = static_cast<float>(1.0 / (above->Elevation() - grid.Elevation()));
  const double step = grid.GateSpacing() / above->GateSpacing();
  const double from = (grid.RangeOf(0) - above->RangeOf(0)) / above->GateSpacing() + 0.5;
  for (std::size_t i = 0; i < evidence.gates.size(); ++i)
  {
    const double at = from + step * static_cast<double>(evidence.gates[i]);
    if (at >= 0.0 && at < static_cast<double>(above->Gates()))
    {
      const float value = evidence.reflectivity[i];
      const float over = std::max(upper[static_cast<std::size_t>(at)], std::min(weakest, value));
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
