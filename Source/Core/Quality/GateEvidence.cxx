// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Quality/GateEvidence.h"

#include <algorithm>
#include <cmath>

namespace nexrad
{

namespace
{

constexpr float alike = 3.0F;    // dB
constexpr float weakest = -5.0F; // dBZ that a tilt without echo counts as

void AddTo(std::vector<float>& sum, const std::vector<float>& more)
{
  for (std::size_t i = 0; i < sum.size(); ++i)
  {
    sum[i] += more[i];
  }
}

// Means where there is a count, else NoNumber.
void Divide(std::vector<float>& sum, const std::vector<float>& count)
{
  for (std::size_t i = 0; i < sum.size(); ++i)
  {
    sum[i] = count[i] > 0.5F ? sum[i] / count[i] : NoNumber;
  }
}

} // namespace

EvidenceReader::EvidenceReader(const EchoGrid& theGrid, const EchoGrid* theAbove,
  const SweepSources& theSources, std::size_t gates)
  : grid(theGrid)
  , above(theAbove)
  , sources(theSources)
  , geometry{gates, theGrid.RangeOf(0), theGrid.GateSpacing()}
{
  for (RaySums& each : kept)
  {
    each.place = grid.Rays();
  }
}

const EvidenceReader::RaySums& EvidenceReader::SumsOf(std::size_t place)
{
  for (const RaySums& each : kept)
  {
    if (each.place == place)
    {
      return each;
    }
  }
  RaySums& sums = kept[next];
  next = (next + 1) % kept.size();
  sums.place = place;
  const std::size_t ray = grid.RayAt(place);
  sums.reflectivity.Set(grid.Row(place), geometry);
  sums.velocity.Set(sources.velocity[ray], geometry);
  sums.polarimetric.Set(sources.twoWaves[ray], grid.Row(place), geometry);
  return sums;
}

void EvidenceReader::Read(std::size_t place, RowEvidence& evidence)
{
  const std::size_t none = grid.Rays();
  const std::size_t before = grid.Beside(place, -1);
  const std::size_t after = grid.Beside(place, 1);
  std::vector<float> pairs(geometry.gates, 0.0F);
  std::vector<float> velocities(geometry.gates, 0.0F);
  std::vector<float> correlations(geometry.gates, 0.0F);
  std::vector<float> differences(geometry.gates, 0.0F);
  for (std::vector<float>* each :
    {&evidence.squares, &evidence.turns, &evidence.still, &evidence.speed, &evidence.width,
      &evidence.correlation, &evidence.ratio, &evidence.ratioSpread, &evidence.phaseSpread})
  {
    each->assign(geometry.gates, 0.0F);
  }
  for (const std::size_t each : {before, place, after})
  {
    if (each == none)
    {
      continue;
    }
    const RaySums& sums = this->SumsOf(each);
    AddTo(pairs, sums.reflectivity.pairs);
    AddTo(evidence.squares, sums.reflectivity.squares);
    AddTo(evidence.turns, sums.reflectivity.turns);
    AddTo(velocities, sums.velocity.count);
    AddTo(evidence.still, sums.velocity.still);
    AddTo(evidence.speed, sums.velocity.speed);
    AddTo(evidence.width, sums.velocity.width);
    AddTo(correlations, sums.polarimetric.count);
    AddTo(evidence.correlation, sums.polarimetric.correlation);
    AddTo(evidence.ratio, sums.polarimetric.ratio);
    AddTo(differences, sums.polarimetric.pairs);
    AddTo(evidence.ratioSpread, sums.polarimetric.ratioSquares);
    AddTo(evidence.phaseSpread, sums.polarimetric.phaseSquares);
  }
  Divide(evidence.squares, pairs);
  Divide(evidence.turns, pairs);
  for (std::vector<float>* each : {&evidence.still, &evidence.speed, &evidence.width})
  {
    Divide(*each, velocities);
  }
  Divide(evidence.correlation, correlations);
  Divide(evidence.ratio, correlations);
  for (std::vector<float>* each : {&evidence.ratioSpread, &evidence.phaseSpread})
  {
    Divide(*each, differences);
    std::transform(each->begin(), each->end(), each->begin(),
      [](float square) { return square >= 0.0F ? std::sqrt(0.5F * square) : NoNumber; });
  }
  const VelocitySums& own = this->SumsOf(place).velocity;
  evidence.ownStill = own.ownStill;
  Divide(evidence.ownStill, own.ownCount);
  this->ReadAgreement(place, evidence);
  this->ReadGradient(place, evidence);
}

void EvidenceReader::ReadAgreement(std::size_t place, RowEvidence& evidence) const
{
  const std::size_t count = geometry.gates;
  std::vector<float> about(count, 0.0F);
  evidence.agreement.assign(count, 0.0F);
  const float* own = grid.Row(place);
  const std::ptrdiff_t far = static_cast<std::ptrdiff_t>(geometry.HalfWindow());
  for (const int step : {-1, 0, 1})
  {
    const float* row = step == 0 ? own : grid.RowBeside(place, step);
    for (const std::ptrdiff_t offset :
      {-far, std::ptrdiff_t(-1), std::ptrdiff_t(0), std::ptrdiff_t(1), far})
    {
      if (step == 0 && offset == 0)
      {
        continue;
      }
      const std::size_t begin = offset < 0 ? static_cast<std::size_t>(-offset) : 0;
      const std::size_t end = offset > 0 ? count - std::min(count, std::size_t(offset)) : count;
      for (std::size_t i = begin; i < end; ++i)
      {
        const float other = row[i + static_cast<std::size_t>(offset)];
        about[i] += IsNumber(other) ? 1.0F : 0.0F;
        evidence.agreement[i] += std::abs(other - own[i]) < alike ? 1.0F : 0.0F;
      }
    }
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    evidence.agreement[i] = about[i] > 2.5F ? evidence.agreement[i] / about[i] : NoNumber;
  }
}

void EvidenceReader::ReadGradient(std::size_t place, RowEvidence& evidence) const
{
  evidence.gradient.assign(geometry.gates, NoNumber);
  if (above == nullptr)
  {
    return;
  }
  const std::size_t over = above->PlaceAt(grid.AzimuthAt(place));
  if (over == above->Rays())
  {
    return;
  }
  const float* row = grid.Row(place);
  const float* upper = above->Row(over);
  const auto perDegree = static_cast<float>(1.0 / (above->Elevation() - grid.Elevation()));
  for (std::size_t i = 0; i < geometry.gates; ++i)
  {
    const std::ptrdiff_t at = above->GateAt(grid.RangeOf(i));
    if (IsNumber(row[i]) && at >= 0 && at < static_cast<std::ptrdiff_t>(above->Gates()))
    {
      evidence.gradient[i] = (row[i] - std::max(upper[at], std::min(weakest, row[i]))) * perDegree;
    }
  }
}

} // namespace nexrad
