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

void Evaluate(const GateSums& sums, const GateSums& own, GateEvidence& evidence)
{
  const float pairs = At(sums, SumOf::Pairs);
  evidence.squares = Mean(At(sums, SumOf::Squares), pairs);
  evidence.turns = Mean(At(sums, SumOf::Turns), pairs);
  const float velocities = At(sums, SumOf::Velocities);
  evidence.still = Mean(At(sums, SumOf::Still), velocities);
  evidence.speed = Mean(At(sums, SumOf::Speed), velocities);
  evidence.width = Mean(At(sums, SumOf::Width), velocities);
  evidence.ownStill = Mean(At(own, SumOf::Still), At(own, SumOf::Velocities));
  evidence.ownSpeed = Mean(At(own, SumOf::Speed), At(own, SumOf::Velocities));
  evidence.flow = std::abs(At(sums, SumOf::Velocity)) / std::max(At(sums, SumOf::Speed), 0.1F);
  const float correlations = At(sums, SumOf::Correlations);
  evidence.correlation = Mean(At(sums, SumOf::Correlation), correlations);
  evidence.ratio = Mean(At(sums, SumOf::Ratio), correlations);
  evidence.ownCorrelation = Mean(At(own, SumOf::Correlation), At(own, SumOf::Correlations));
  const float ratioPairs = At(sums, SumOf::RatioPairs);
  evidence.ratioSpread = Spread(At(sums, SumOf::RatioSquares), ratioPairs);
  evidence.phaseSpread = Spread(At(sums, SumOf::PhaseSquares), ratioPairs);
}

} // namespace

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

void EvidenceReader::Read(std::size_t place, std::vector<GateEvidence>& evidence)
{
  const std::size_t gates = std::min(geometry.gates, grid.Held(place).end);
  evidence.resize(geometry.gates);
  sums.assign(gates, GateSums{});
  for (const std::size_t each : {grid.Beside(place, -1), place, grid.Beside(place, 1)})
  {
    if (each == grid.Rays())
    {
      continue;
    }
    const std::vector<GateSums>& windows = this->TexturesOf(each).Windows();
    for (std::size_t i = 0; i < std::min(gates, windows.size()); ++i)
    {
      for (std::size_t which = 0; which < SumCount; ++which)
      {
        sums[i][which] += windows[i][which];
      }
    }
  }
  const float* row = grid.Row(place);
  const std::vector<GateSums>& own = this->TexturesOf(place).Own();
  for (std::size_t i = 0; i < gates; ++i)
  {
    if (IsNumber(row[i]))
    {
      evidence[i] = GateEvidence();
      evidence[i].reflectivity = row[i];
      evidence[i].elevation = static_cast<float>(grid.Elevation());
      evidence[i].range = static_cast<float>(grid.RangeOf(i));
      Evaluate(sums[i], own[i], evidence[i]);
    }
  }
  this->ReadAgreement(place, evidence);
  this->ReadGradient(place, evidence);
  this->ReadFilterPower(place, evidence);
}

void EvidenceReader::ReadAgreement(std::size_t place, std::vector<GateEvidence>& evidence) const
{
  const auto count = static_cast<std::ptrdiff_t>(std::min(geometry.gates, grid.Held(place).end));
  const float* own = grid.Row(place);
  const auto far = static_cast<std::ptrdiff_t>(geometry.HalfWindow());
  const std::array<const float*, 3> rows = {
    grid.RowBeside(place, -1), own, grid.RowBeside(place, 1)};
  for (std::ptrdiff_t i = 0; i < count; ++i)
  {
    if (!IsNumber(own[i]))
    {
      continue;
    }
    float about = 0.0F;
    float like = 0.0F;
    for (const std::ptrdiff_t at : {i - far, i - 1, i, i + 1, i + far})
    {
      for (std::size_t each = 0; each < rows.size() && at >= 0 && at < count; ++each)
      {
        const float other = rows[each][at];
        about += IsNumber(other) ? 1.0F : 0.0F;
        like += std::abs(other - own[i]) < alike ? 1.0F : 0.0F;
      }
    }
    // The gate itself is one of them.
    evidence[static_cast<std::size_t>(i)].agreement =
      about > 3.5F ? (like - 1.0F) / (about - 1.0F) : NoNumber;
  }
}

void EvidenceReader::ReadGradient(std::size_t place, std::vector<GateEvidence>& evidence) const
{
  if (above == nullptr)
  {
    return;
  }
  const std::size_t beyond = above->PlaceAt(grid.AzimuthAt(place));
  if (beyond == above->Rays())
  {
    return;
  }
  const float* row = grid.Row(place);
  const float* upper = above->Row(beyond);
  const auto perDegree = static_cast<float>(1.0 / (above->Elevation() - grid.Elevation()));
  const double step = grid.GateSpacing() / above->GateSpacing();
  const double from = (grid.RangeOf(0) - above->RangeOf(0)) / above->GateSpacing() + 0.5;
  const std::size_t gates = std::min(geometry.gates, grid.Held(place).end);
  for (std::size_t i = 0; i < gates; ++i)
  {
    const double at = from + step * static_cast<double>(i);
    if (IsNumber(row[i]) && at >= 0.0 && at < static_cast<double>(above->Gates()))
    {
      const float over = std::max(upper[static_cast<std::size_t>(at)], std::min(weakest, row[i]));
      evidence[i].gradient = (row[i] - over) * perDegree;
    }
  }
}

void EvidenceReader::ReadFilterPower(std::size_t place, std::vector<GateEvidence>& evidence)
{
  const std::size_t ray = grid.RayAt(place);
  if (!sources.filterPower.Has(ray))
  {
    return;
  }
  ReadMoment(sources.filterPower, ray, geometry, codes, filterPower);
  for (std::size_t i = 0; i < evidence.size(); ++i)
  {
    evidence[i].filterPower = filterPower[i];
  }
}

} // namespace nexrad
