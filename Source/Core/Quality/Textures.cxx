// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Quality/Textures.h"

#include <algorithm>
#include <cmath>

namespace nexrad
{

namespace
{

constexpr float largestSquare = 400.0F;       // dB²
constexpr float largestPhaseSquare = 3600.0F; // degrees²
constexpr float stillSpeed = 0.25F;           // m/s
constexpr float usualWidth = 2.0F;            // m/s, where none is measured

// Sums up the gates within `half` of each. `prefix` is room that is used.
void SumWindows(std::size_t half, std::vector<GateSums>& prefix, RowSums& sums)
{
  const std::vector<GateSums>& own = sums.own;
  std::vector<GateSums>& windows = sums.windows;
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

void AddOneVelocity(float velocity, float width, GateSums& sums)
{
  const float speed = std::abs(velocity);
  At(sums, SumOf::Velocities) += 1.0F;
  At(sums, SumOf::Still) += Ramp(speed, MovingSpeed, stillSpeed);
  At(sums, SumOf::Velocity) += velocity;
  At(sums, SumOf::Speed) += speed;
  At(sums, SumOf::Width) += width;
}

// Codes from `first` up to `last`; none where the first is the larger one.
struct CodeRange
{
  std::uint16_t first;
  std::uint16_t last;

  bool Holds(std::uint16_t code) const { return code >= first && code <= last; }
};

// Those of velocities below MovingSpeed.
CodeRange StillCodes(const GateScale& scale)
{
  const auto isStill = [&scale](std::uint16_t code)
  { return std::abs(scale.ValueOf(code)) < MovingSpeed; };
  CodeRange range = {GateCode::FirstValue, GateCode::FirstValue};
  if (scale.step > 0.0F)
  {
    range = {scale.CodeOf(-MovingSpeed), scale.CodeOf(MovingSpeed)};
  }
  range.first += isStill(range.first) ? 0 : 1; // CodeOf rounds
  range.last -= isStill(range.last) ? 0 : 1;
  return range;
}

// Whether some of `count` codes are of a range. No branch: the compiler compares several at once.
bool HoldsAny(const std::uint16_t* codes, std::size_t count, const CodeRange& range)
{
  unsigned any = 0;
  for (std::size_t i = 0; i < count; ++i)
  {
    any |= static_cast<unsigned>(codes[i] >= range.first) & // both sides, without a branch
           static_cast<unsigned>(codes[i] <= range.last);
  }
  return any != 0;
}

// The first number of a gate that is not below a place counted in gates.
std::size_t FirstAtLeast(double place)
{
  const auto before = static_cast<std::int64_t>(std::max(place, 0.0));
  return static_cast<std::size_t>(before) + (static_cast<double>(before) < place ? 1 : 0);
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

GateRange StillGates(const float* row, const GateRange& held, const MomentSource& velocity,
  std::size_t ray, const RowGeometry& geometry, std::vector<std::uint16_t>& codes)
{
  if (!velocity.Has(ray) || geometry.gates == 0 || held.IsEmpty())
  {
    return {};
  }
  const PolarSweep& sweep = *velocity.sweep;
  const CodeRange still = StillCodes(sweep.scale);
  const double step = sweep.gateSpacing / geometry.spacing;
  const double from = (sweep.firstGate - geometry.firstGate) / geometry.spacing + 0.5;
  // The first velocity in or behind a gate of the row.
  const auto firstIn = [&](std::size_t gate)
  {
    const double place = (static_cast<double>(gate) - from) / step;
    return std::min(FirstAtLeast(place), sweep.gates);
  };
  std::size_t begin = firstIn(std::min(held.begin, geometry.gates));
  std::size_t end = firstIn(std::min(held.end, geometry.gates));
  codes.resize(end);
  sweep.rows.Read(velocity.rays[ray], end, codes.data());
  const auto last = static_cast<double>(geometry.gates - 1);
  const auto gateOf = [&](std::size_t i)
  { return static_cast<std::size_t>(std::clamp(from + step * static_cast<double>(i), 0.0, last)); };
  const auto isStill = [&](std::size_t i)
  {
    const std::size_t gate = gateOf(i);
    return still.Holds(codes[i]) && held.Holds(gate) && IsNumber(row[gate]);
  };
  constexpr std::size_t together = 32;
  while (begin < end && !isStill(begin))
  {
    const bool skips = begin + together <= end && !HoldsAny(&codes[begin], together, still);
    begin += skips ? together : 1;
  }
  while (begin < end && !isStill(end - 1))
  {
    const bool skips =
      begin + together <= end && !HoldsAny(&codes[end - together], together, still);
    end -= skips ? together : 1;
  }
  return begin < end ? GateRange{gateOf(begin), gateOf(end - 1) + 1} : GateRange();
}

void RayTextures::Set(
  const float* row, const SweepSources& sources, std::size_t ray, const RowGeometry& geometry)
{
  sums.own.assign(geometry.gates, GateSums{});
  this->AddReflectivity(row, geometry.gates);
  this->AddVelocity(sources, ray, geometry);
  SumWindows(geometry.HalfWindow(), prefix, sums);
  const bool polarimetric = sources.correlation.Has(ray) && sources.ratio.Has(ray);
  polarimetricSums.own.assign(polarimetric ? geometry.gates : 0, GateSums{});
  if (polarimetric)
  {
    this->AddPolarimetry(row, sources, ray, geometry);
  }
  SumWindows(geometry.HalfWindow(), prefix, polarimetricSums);
}

void RayTextures::AddReflectivity(const float* row, std::size_t gates)
{
  float before = 0.0F; // the difference from the gate before; 0 where one of them has no number
  for (std::size_t i = 0; i + 1 < gates; ++i)
  {
    const bool pair = IsNumber(row[i]) && IsNumber(row[i + 1]);
    const float after = pair ? row[i + 1] - row[i] : 0.0F;
    const bool turn = before * after < 0.0F && std::abs(before) + std::abs(after) > 4.0F;
    At(sums.own[i], SumOf::Pairs) = pair ? 1.0F : 0.0F;
    At(sums.own[i], SumOf::Squares) = std::min(after * after, largestSquare);
    At(sums.own[i], SumOf::Turns) = turn ? 1.0F : 0.0F;
    before = after;
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
  const double inGates = geometry.spacing / velocity.gateSpacing;
  const double from = (velocity.firstGate - geometry.firstGate) / geometry.spacing + 0.5;
  // The first gate of velocity behind a gate of the row.
  const auto behind = [&](std::size_t gate)
  {
    const double place = (static_cast<double>(gate + 1) - from) * inGates;
    return std::min(FirstAtLeast(place), velocity.gates);
  };
  const std::size_t gates = geometry.gates > 0 ? behind(geometry.gates - 1) : 0;
  codes.resize(gates);
  velocity.rows.Read(sources.velocity.rays[ray], gates, codes.data());
  const PolarSweep* width = sources.width.Has(ray) ? sources.width.sweep : nullptr;
  widthCodes.assign(gates, GateCode::NotSampled);
  if (width && width->firstGate == velocity.firstGate && width->gateSpacing == velocity.gateSpacing)
  {
    width->rows.Read(sources.width.rays[ray], std::min(width->gates, gates), widthCodes.data());
  }
  const GateScale widthScale = width ? width->scale : GateScale();
  std::size_t i = FirstAtLeast(-from * inGates);
  for (std::size_t at = 0; at < geometry.gates && i < gates; ++at)
  {
    const std::size_t end = behind(at);
    GateSums own = sums.own[at];
    for (; i < end; ++i)
    {
      if (codes[i] >= GateCode::FirstValue)
      {
        const bool hasWidth = widthCodes[i] >= GateCode::FirstValue;
        AddOneVelocity(velocity.scale.ValueOf(codes[i]),
          hasWidth ? std::max(widthScale.ValueOf(widthCodes[i]), 0.0F) : usualWidth, own);
      }
    }
    sums.own[at] = own;
  }
}

void RayTextures::AddPolarimetry(
  const float* row, const SweepSources& sources, std::size_t ray, const RowGeometry& geometry)
{
  std::vector<GateSums>& own = polarimetricSums.own;
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
    At(own[i], PolarimetricSumOf::Correlations) = 1.0F;
    At(own[i], PolarimetricSumOf::Correlation) = std::min(correlation[i], 1.0F);
    At(own[i], PolarimetricSumOf::Ratio) = ratio[i];
    if (i + 1 < geometry.gates && known(i + 1) && IsNumber(phase[i]) && IsNumber(phase[i + 1]))
    {
      const float ratios = ratio[i + 1] - ratio[i];
      float phases = std::abs(phase[i + 1] - phase[i]);
      phases = phases > 180.0F ? 360.0F - phases : phases;
      At(own[i], PolarimetricSumOf::RatioPairs) = 1.0F;
      At(own[i], PolarimetricSumOf::RatioSquares) = ratios * ratios;
      At(own[i], PolarimetricSumOf::PhaseSquares) = std::min(phases * phases, largestPhaseSquare);
    }
  }
}

} // namespace nexrad
