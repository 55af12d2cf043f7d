// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Simulation/RayBlocks.h"

#include "nexrad/Simulation/RayWords.h"

#include <algorithm>

namespace nexrad
{

namespace
{

void SetRow(
  MomentRow& row, const GateLayout& layout, const std::uint8_t* words, const WordCode& code)
{
  if (layout.gates > 0)
  {
    row.words = words;
    row.gates = static_cast<std::uint16_t>(layout.gates);
    row.firstGate = layout.firstGate;
    row.gateSpacing = layout.gateSpacing;
    row.scale = code.scale;
    row.offset = code.offset;
  }
}

} // namespace

RayBlocks::RayBlocks(const CutLayout& layout, int polarimetricCount, std::uint8_t* words)
  : reflectivityGates(layout.reflectivity)
  , dopplerGates(layout.doppler)
  , polarimetricGates(layout.reflectivity)
  , reflectivity(words)
  , velocity(words + reflectivityGates.gates)
  , width(velocity + dopplerGates.gates)
  , polarimetric(width + dopplerGates.gates)
{
  polarimetricGates.gates = polarimetricCount;
}

std::size_t RayBlocks::Bytes(const CutLayout& layout, int polarimetricCount)
{
  return static_cast<std::size_t>(layout.reflectivity.gates) +
         2 * static_cast<std::size_t>(layout.doppler.gates) +
         4 * static_cast<std::size_t>(polarimetricCount);
}

void RayBlocks::Describe(Ray& ray) const
{
  const int count = polarimetricGates.gates;
  SetRow(ray.Row(MomentName::REF), reflectivityGates, reflectivity, ReflectivityCode);
  SetRow(ray.Row(MomentName::VEL), dopplerGates, velocity, DopplerCode);
  SetRow(ray.Row(MomentName::SW), dopplerGates, width, DopplerCode);
  SetRow(ray.Row(MomentName::ZDR), polarimetricGates, polarimetric, DifferentialCode);
  SetRow(ray.Row(MomentName::PHI), polarimetricGates, polarimetric + count, PhaseCode);
  SetRow(ray.Row(MomentName::RHO), polarimetricGates, polarimetric + 3 * count, CorrelationCode);
  if (count > 0)
  {
    ray.Row(MomentName::PHI).wordBits = 16;
  }
}

void RayBlocks::FillWithPattern() const
{
  constexpr std::uint8_t strength = 136;  // 35 dBZ
  constexpr std::uint8_t speed = 149;     // 10 m/s
  constexpr std::uint8_t spread = 137;    // 4 m/s
  constexpr std::uint8_t agreement = 144; // 1 dB of Z_DR, and 0.68 of correlation
  constexpr std::uint8_t phaseBytes = 1;  // twice: the word 257, 89.9°
  const int count = polarimetricGates.gates;
  std::fill(reflectivity, velocity, strength);
  std::fill(velocity, width, speed);
  std::fill(width, polarimetric, spread);
  std::fill(polarimetric, polarimetric + count, agreement);
  std::fill(polarimetric + count, polarimetric + 3 * count, phaseBytes);
  std::fill(polarimetric + 3 * count, polarimetric + 4 * count, agreement);
}

} // namespace nexrad
