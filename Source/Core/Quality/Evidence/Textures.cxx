// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Quality/Evidence/Textures.h"

#include <algorithm>
#include <cmath>

namespace nexrad
{

namespace
{

constexpr float largestSquare = 400.0F;       // dB²
constexpr float largestPhaseSquare = 3600.0F; // degrees²
constexpr float stillSpeed = 0.25F;           // m/s
constexpr float movingSpeed = 1.5F;           // m/s
constexpr float usualWidth = 2.0F;            // m/s, where none is measured

// Sums of the gates within `half` of each.
void SumWindows(const std::vector<GateSums>& own, std::size_t half, std::vector<GateSums>& prefix,
  std::vector<GateSums>& windows)
{
  const std::size_t count = own.size();
  prefix.resize(count + 1);
  windows.resize(count > 0 ? count + half : 0);
  GateSums sum{};
  prefix[0] = sum;
  for (std::size_t i = 0; i < count; ++i)
  {
    for (std::size_t each = 0; each < SumCount; ++each)
    {
      sum[each] += own[i][each];
    }
    prefix[i + 1] = sum;
  }
  for (std::size_t i = 0; i < windows.size(); ++i)
  {
    const GateSums& from = prefix[i > half ? i - half : 0];
    const GateSums& to = prefix[std::min(i + half + 1, count)];
    for (std::size_t each = 0; each < SumCount; ++each)
    {
      windows[i][each] = to[each] - from[each];
    }
  }
}

} // namespace

std::size_t RowGeometry::HalfWindow() const
{
  return static_cast<std::size_t>(std::clamp(std::lround(1000.0 / spacing), 2L, 20L));
}

void ReadMoment(const MomentSource& source, std::size_t ray, const RowGeometry& geometry,
  std::vector<std::uint16_t>& codes, std::vector<float>& values)
{
  values.assign(geometry.gates, NoNumber);
  if (!source.Has(ray))
  {
    return;
  }
  const PolarSweep& sweep = *source.sweep;
  codes.resize(sweep.gates);
  sweep.Read(source.rays[ray], codes.data());
  const double step = geometry.spacing / sweep.gateSpacing;
  const double from = (geometry.firstGate - sweep.firstGate) / sweep.gateSpacing + 0.5;
  const bool same = step == 1.0 && from >= 0.0;
  for (std::size_t gate = 0; gate < geometry.gates; ++gate)
  {
    const double place = from + step * static_cast<double>(gate);
    const std::size_t at =
      same ? gate + static_cast<std::size_t>(from) : static_cast<std::size_t>(std::max(place, 0.0));
    if (at >= sweep.gates)
    {
      break;
    }
    const float value = sweep.scale.ValueOf(codes[at]);
    values[gate] = place >= 0.0 && codes[at] >= GateCode::FirstValue ? value : NoNumber;
  }
}

void RayTextures::Set(
  const float* row, const SweepSources& sources, std::size_t ray, const RowGeometry& geometry)
{
  own.assign(geometry.gates, GateSums{});
  this->AddReflectivity(row, geometry.gates);
  this->AddVelocity(sources, ray, geometry);
  this->AddPolarimetry(row, sources, ray, geometry);
  SumWindows(own, geometry.HalfWindow(), prefix, windows);
}

void RayTextures::AddReflectivity(const float* row, std::size_t gates)
{
  for (std::size_t i = 0; i + 1 < gates; ++i)
  {
    if (!IsNumber(row[i]) || !IsNumber(row[i + 1]))
    {
      continue;
    }
    const float after = row[i + 1] - row[i];
    At(own[i], SumOf::Pairs) = 1.0F;
    At(own[i], SumOf::Squares) = std::min(after * after, largestSquare);
    if (i > 0 && IsNumber(row[i - 1]))
    {
      const float before = row[i] - row[i - 1];
      const bool turn = before * after < 0.0F && std::abs(before) + std::abs(after) > 4.0F;
      At(own[i], SumOf::Turns) = turn ? 1.0F : 0.0F;
    }
  }
}

void RayTextures::AddVelocity(
  const SweepSources& sources, std::size_t ray, const RowGeometry& geometry)
{
  if (!sources.velocity.Has(ray))
  {
    return;
  }
  const PolarSweep& velocity = *sources.velocity.sweep;
  codes.resize(velocity.gates);
  velocity.Read(sources.velocity.rays[ray], codes.data());
  const PolarSweep* width = sources.width.Has(ray) ? sources.width.sweep : nullptr;
  widthCodes.assign(velocity.gates, GateCode::NotSampled);
  if (width && width->firstGate == velocity.firstGate && width->gateSpacing == velocity.gateSpacing)
  {
    width->rows.Read(
      sources.width.rays[ray], std::min(width->gates, velocity.gates), widthCodes.data());
  }
  const double perGate = velocity.gateSpacing / geometry.spacing;
  const double from = (velocity.firstGate - geometry.firstGate) / geometry.spacing + 0.5;
  for (std::size_t i = 0; i < velocity.gates; ++i)
  {
    const double place = from + perGate * static_cast<double>(i);
    const auto at = static_cast<std::size_t>(std::max(place, 0.0));
    if (at >= geometry.gates)
    {
      break;
    }
    if (place < 0.0 || codes[i] < GateCode::FirstValue)
    {
      continue;
    }
    const bool hasWidth = widthCodes[i] >= GateCode::FirstValue;
    const float ofVelocity = velocity.scale.ValueOf(codes[i]);
    const float ofSpeed = std::abs(ofVelocity);
    const float ofWidth =
      hasWidth ? std::max(width->scale.ValueOf(widthCodes[i]), 0.0F) : usualWidth;
    At(own[at], SumOf::Velocities) += 1.0F;
    At(own[at], SumOf::Velocity) += ofVelocity;
    At(own[at], SumOf::Speed) += ofSpeed;
    At(own[at], SumOf::Width) += ofWidth;
    At(own[at], SumOf::Still) += Ramp(ofSpeed, movingSpeed, stillSpeed);
  }
}

void RayTextures::AddPolarimetry(
  const float* row, const SweepSources& sources, std::size_t ray, const RowGeometry& geometry)
{
  if (!sources.correlation.Has(ray) || !sources.ratio.Has(ray))
  {
    return;
  }
  ReadMoment(sources.correlation, ray, geometry, codes, correlation);
  ReadMoment(sources.ratio, ray, geometry, codes, ratio);
  ReadMoment(sources.phase, ray, geometry, codes, phase);
  const auto known = [&](std::size_t i)
  { return IsNumber(correlation[i]) && IsNumber(ratio[i]) && IsNumber(row[i]); };
  for (std::size_t i = 0; i < geometry.gates; ++i)
  {
    if (!known(i))
    {
      continue;
    }
    At(own[i], SumOf::Correlations) = 1.0F;
    At(own[i], SumOf::Correlation) = std::min(correlation[i], 1.0F);
    At(own[i], SumOf::Ratio) = ratio[i];
    if (i + 1 < geometry.gates && known(i + 1) && IsNumber(phase[i]) && IsNumber(phase[i + 1]))
    {
      const float ratios = ratio[i + 1] - ratio[i];
      float phases = std::abs(phase[i + 1] - phase[i]);
      phases = phases > 180.0F ? 360.0F - phases : phases;
      At(own[i], SumOf::RatioPairs) = 1.0F;
      At(own[i], SumOf::RatioSquares) = ratios * ratios;
      At(own[i], SumOf::PhaseSquares) = std::min(phases * phases, largestPhaseSquare);
    }
  }
}

} // namespace nexrad
