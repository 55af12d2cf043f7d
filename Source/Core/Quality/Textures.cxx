// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Quality/Textures.h"

#include <algorithm>
#include <cmath>

namespace nexrad
{

namespace
{

constexpr float largestSquare = 400.0F; // dB²
constexpr float stillSpeed = 1.3F;      // m/s
constexpr float stillWidth = 1.8F;      // m/s

// Replaces each element by the sum of those within `half` of it.
void SumWindows(std::vector<float>& values, std::size_t half, std::vector<float>& prefix)
{
  const std::size_t count = values.size();
  prefix.resize(count + 1);
  prefix[0] = 0.0F;
  for (std::size_t i = 0; i < count; ++i)
  {
    prefix[i + 1] = prefix[i] + values[i];
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    const std::size_t from = i > half ? i - half : 0;
    const std::size_t to = std::min(i + half + 1, count);
    values[i] = prefix[to] - prefix[from];
  }
}

void Clear(std::vector<float>& values, std::size_t count)
{
  values.assign(count, 0.0F);
}

} // namespace

std::size_t RowGeometry::HalfWindow() const
{
  return static_cast<std::size_t>(std::clamp(std::lround(1000.0 / spacing), 2L, 20L));
}

void ReadMoment(const Ray* ray, MomentName moment, const RowGeometry& geometry, float* values)
{
  std::fill(values, values + geometry.gates, NoNumber);
  if (ray == nullptr)
  {
    return;
  }
  const MomentRow& row = ray->Row(moment);
  if (row.gates == 0 || row.gateSpacing <= 0)
  {
    return;
  }
  const double step = geometry.spacing / row.gateSpacing;
  const double from = (geometry.firstGate - row.firstGate) / row.gateSpacing + 0.5;
  const float perWord = 1.0F / row.scale;
  for (std::size_t gate = 0; gate < geometry.gates; ++gate)
  {
    const double place = from + step * static_cast<double>(gate);
    if (place < 0.0)
    {
      continue;
    }
    const auto at = static_cast<std::size_t>(place);
    if (at >= row.gates)
    {
      break;
    }
    const unsigned word = row.Raw(at);
    values[gate] =
      word >= row.firstValue ? (static_cast<float>(word) - row.offset) * perWord : NoNumber;
  }
}

void ReflectivitySums::Set(const float* row, const RowGeometry& geometry)
{
  const std::size_t count = geometry.gates;
  Clear(pairs, count);
  Clear(squares, count);
  Clear(turns, count);
  for (std::size_t i = 0; i + 1 < count; ++i)
  {
    const float difference = row[i + 1] - row[i];
    const bool both = IsNumber(row[i]) && IsNumber(row[i + 1]);
    pairs[i] = both ? 1.0F : 0.0F;
    squares[i] = both ? std::min(difference * difference, largestSquare) : 0.0F;
  }
  for (std::size_t i = 1; i + 1 < count; ++i)
  {
    const float before = row[i] - row[i - 1];
    const float after = row[i + 1] - row[i];
    const bool all = pairs[i] + pairs[i - 1] > 1.5F;
    const bool turn = before * after < 0.0F && std::abs(before) + std::abs(after) > 4.0F;
    turns[i] = all && turn ? 1.0F : 0.0F;
  }
  std::vector<float> prefix;
  const std::size_t half = geometry.HalfWindow();
  for (std::vector<float>* each : {&pairs, &squares, &turns})
  {
    SumWindows(*each, half, prefix);
  }
}

void VelocitySums::Set(const Ray* ray, const RowGeometry& geometry)
{
  const std::size_t gates = geometry.gates;
  for (std::vector<float>* each : {&ownCount, &ownStill, &ownSpeed, &ownWidth})
  {
    Clear(*each, gates);
  }
  if (ray != nullptr)
  {
    const MomentRow& velocity = ray->Row(MomentName::VEL);
    const MomentRow& spectrum = ray->Row(MomentName::SW);
    const bool together = spectrum.gates >= velocity.gates &&
                          spectrum.firstGate == velocity.firstGate &&
                          spectrum.gateSpacing == velocity.gateSpacing;
    const double perGate = velocity.gateSpacing / geometry.spacing;
    const double from = (velocity.firstGate - geometry.firstGate) / geometry.spacing + 0.5;
    for (std::size_t i = 0; i < velocity.gates; ++i)
    {
      const double place = from + perGate * static_cast<double>(i);
      const auto at = static_cast<std::size_t>(std::max(place, 0.0));
      if (at >= gates)
      {
        break;
      }
      if (place < 0.0 || velocity.State(i) != GateState::Valid)
      {
        continue;
      }
      const bool hasWidth = together && spectrum.State(i) == GateState::Valid;
      const float ofSpeed = std::abs(velocity.Value(i));
      const float ofWidth = hasWidth ? std::max(spectrum.Value(i), 0.0F) : 2.0F;
      ownCount[at] += 1.0F;
      ownSpeed[at] += ofSpeed;
      ownWidth[at] += ofWidth;
      ownStill[at] += ofSpeed < stillSpeed && ofWidth < stillWidth ? 1.0F : 0.0F;
    }
  }
  std::vector<float> prefix;
  const std::size_t half = geometry.HalfWindow();
  count = ownCount;
  still = ownStill;
  speed = ownSpeed;
  width = ownWidth;
  for (std::vector<float>* each : {&count, &still, &speed, &width})
  {
    SumWindows(*each, half, prefix);
  }
}

void PolarimetricSums::Set(const Ray* ray, const float* row, const RowGeometry& geometry)
{
  const std::size_t gates = geometry.gates;
  ownCorrelation.resize(gates);
  ownRatio.resize(gates);
  std::vector<float> phase(gates);
  ReadMoment(ray, MomentName::RHO, geometry, ownCorrelation.data());
  ReadMoment(ray, MomentName::ZDR, geometry, ownRatio.data());
  ReadMoment(ray, MomentName::PHI, geometry, phase.data());
  for (std::vector<float>* each :
    {&count, &correlation, &ratio, &pairs, &ratioSquares, &phaseSquares})
  {
    Clear(*each, gates);
  }
  const auto known = [&](std::size_t i)
  { return IsNumber(ownCorrelation[i]) && IsNumber(ownRatio[i]) && IsNumber(row[i]); };
  for (std::size_t i = 0; i < gates; ++i)
  {
    if (!known(i))
    {
      continue;
    }
    count[i] = 1.0F;
    correlation[i] = std::min(ownCorrelation[i], 1.0F);
    ratio[i] = ownRatio[i];
    if (i + 1 < gates && known(i + 1) && IsNumber(phase[i]) && IsNumber(phase[i + 1]))
    {
      const float ratios = ownRatio[i + 1] - ownRatio[i];
      float phases = std::abs(phase[i + 1] - phase[i]);
      phases = phases > 180.0F ? 360.0F - phases : phases;
      pairs[i] = 1.0F;
      ratioSquares[i] = ratios * ratios;
      phaseSquares[i] = phases * phases;
    }
  }
  std::vector<float> prefix;
  const std::size_t half = geometry.HalfWindow();
  for (std::vector<float>* each :
    {&count, &correlation, &ratio, &pairs, &ratioSquares, &phaseSquares})
  {
    SumWindows(*each, half, prefix);
  }
}

} // namespace nexrad
