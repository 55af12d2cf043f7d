// SPDX-License-Identifier: BSD-3-Clause
#include "EchoScene.h"

#include <array>
#include <cmath>
#include <cstdint>

namespace nexrad::testing
{

namespace
{

constexpr std::size_t rays = 360;
constexpr std::size_t gates = 150;
constexpr std::array<double, 4> elevations = {0.5, 1.5, 2.4, 4.3};
constexpr std::array<MomentName, 6> names = {MomentName::REF, MomentName::VEL, MomentName::SW,
  MomentName::RHO, MomentName::ZDR, MomentName::PHI};

float ValueOf(const SceneGate& gate, MomentName moment)
{
  switch (moment)
  {
  case MomentName::REF:
    return gate.reflectivity;
  case MomentName::VEL:
    return gate.velocity;
  case MomentName::SW:
    return std::isnan(gate.velocity) ? gate.velocity : gate.width;
  case MomentName::RHO:
    return gate.correlation;
  case MomentName::ZDR:
    return std::isnan(gate.correlation) ? gate.correlation : gate.ratio;
  default:
    return std::isnan(gate.correlation) ? gate.correlation : gate.phase;
  }
}

} // namespace

float SceneNoise(std::size_t tilt, std::size_t ray, std::size_t gate, std::size_t kind)
{
  std::uint64_t number = (((tilt * 1000 + ray) * 1000 + gate) * 10 + kind) + 1;
  for (int each = 0; each < 3; ++each)
  {
    number = (number ^ (number >> 31U)) * 0x9E3779B97F4A7C15ULL;
  }
  return static_cast<float>(number >> 40U) / 8388608.0F - 1.0F;
}

EchoScene::EchoScene(const Gates& make)
{
  for (const MomentName name : names)
  {
    for (std::size_t tilt = 0; tilt < elevations.size(); ++tilt)
    {
      NumberSweep sweep = MakeSweep(static_cast<int>(tilt) + 1, elevations[tilt], rays, gates);
      bool any = false;
      for (std::size_t ray = 0; ray < rays; ++ray)
      {
        for (std::size_t gate = 0; gate < gates; ++gate)
        {
          const float value = ValueOf(make(tilt, ray, gate), name);
          if (!std::isnan(value))
          {
            SetGate(sweep, ray, gate, value);
            any = true;
          }
        }
      }
      if (any)
      {
        moments[name].push_back(sweep);
      }
    }
  }
}

PolarVolume EchoScene::Measured(MomentName moment) const
{
  const auto found = moments.find(moment);
  PolarVolume volume = MakeVolume(
    {38.7, -92.0, 200.0}, 0.0, found == moments.end() ? std::vector<NumberSweep>() : found->second);
  volume.moment = moment;
  return volume;
}

EchoClassification EchoScene::Classify(const RangeLoop& loop) const
{
  return ClassifyEcho(
    this->Measured(MomentName::REF),
    [this](MomentName moment, const WantedRange&) { return this->Measured(moment); }, loop);
}

void EchoScene::Remove(MomentName moment)
{
  moments.erase(moment);
}

void EchoScene::SplitFirstTilt()
{
  for (auto& [name, sweeps] : moments)
  {
    for (NumberSweep& sweep : sweeps)
    {
      sweep.elevationNumber += sweep.elevationNumber > 1 ? 1 : 0;
    }
    const bool doppler = name == MomentName::VEL || name == MomentName::SW;
    if (name == MomentName::REF)
    {
      sweeps.insert(sweeps.begin(), sweeps.front());
      sweeps[1].elevationNumber = 2;
    }
    else if (doppler && sweeps.front().elevationNumber == 1)
    {
      sweeps.front().elevationNumber = 2;
    }
  }
}

double ShareOf(const EchoScene& scene, const EchoClassification& found, std::size_t sweep,
  EchoClass echoClass, const std::function<bool(std::size_t ray, std::size_t gate)>& isMeant)
{
  const NumberSweep numbers = NumbersOf(scene.Measured(MomentName::REF).sweeps[sweep]);
  std::size_t all = 0;
  std::size_t of = 0;
  for (std::size_t ray = 0; ray < numbers.rays.size(); ++ray)
  {
    for (std::size_t gate = 0; gate < numbers.gates; ++gate)
    {
      const std::size_t index = numbers.Index(ray, gate);
      if (numbers.states[index] == GateState::Valid && isMeant(ray, gate))
      {
        ++all;
        of += ClassOf(found.sweeps[sweep].At(ray, gate)) == echoClass ? 1 : 0;
      }
    }
  }
  return all == 0 ? 0.0 : static_cast<double>(of) / static_cast<double>(all);
}

} // namespace nexrad::testing
