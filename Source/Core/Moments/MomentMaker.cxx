// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Moments/MomentMaker.h"

#include "nexrad/Moments/PhaseSlopes.h"
#include "nexrad/Quality/Despeckling.h"
#include "nexrad/Quality/EchoClassification.h"
#include "nexrad/Velocity/Dealiasing.h"
#include "nexrad/Velocity/VelocityDerivatives.h"
#include "nexrad/Velocity/WindProfile.h"

#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace nexrad
{

std::optional<Wind> EstimateStormMotion(const VelocityVolume& volume)
{
  constexpr double depth = 6'000.0;      // m over the radar
  constexpr double farthest = 120'000.0; // m along the ground
  constexpr int steps = 60;
  const double beside = 0.5 * ProfileOptions().layerDepth;
  const WindProfile near = FitWindProfile(volume);
  ProfileOptions farther;
  farther.farthest = farthest;
  const WindProfile far = FitWindProfile(volume, farther);
  Wind sum;
  int known = 0;
  for (int step = 0; step < steps; ++step)
  {
    const double height = (step + 0.5) * depth / steps;
    std::optional<Wind> wind = near.At(height, beside);
    wind = wind ? wind : far.At(height, beside);
    if (wind)
    {
      sum.east += wind->east;
      sum.north += wind->north;
      ++known;
    }
  }
  if (3 * known < steps)
  {
    return std::nullopt;
  }
  return Wind{sum.east / known, sum.north / known};
}

namespace
{

// Whether the codes of a sweep already are these velocities.
bool Holds(const PolarSweep& polar, const VelocitySweep& sweep)
{
  std::vector<std::uint16_t> codes(polar.gates);
  for (std::size_t ray = 0; ray < polar.rays.size(); ++ray)
  {
    polar.Read(ray, codes.data());
    for (std::size_t gate = 0; gate < polar.gates; ++gate)
    {
      const std::size_t index = sweep.Index(ray, gate);
      const bool same = codes[gate] < GateCode::FirstValue
                          ? sweep.states[index] != GateState::Valid
                          : sweep.states[index] == GateState::Valid &&
                              sweep.values[index] == polar.scale.ValueOf(codes[gate]);
      if (!same)
      {
        return false;
      }
    }
  }
  return true;
}

} // namespace

bool MomentOptions::operator==(const MomentOptions& other) const
{
  const bool sameMotion = stormMotion.has_value() == other.stormMotion.has_value() &&
                          (!stormMotion || (stormMotion->east == other.stormMotion->east &&
                                             stormMotion->north == other.stormMotion->north));
  return quality == other.quality && dealias == other.dealias && sameMotion;
}

MomentMaker::MomentMaker(const RadarVolume& volume, const MomentOptions& theOptions)
  : MomentMaker([&volume](MomentName moment, const WantedRange& wanted)
      { return MakePolarVolume(volume, moment, wanted); },
      theOptions)
{
}

MomentMaker::MomentMaker(MeasuredVolume theMeasured, const MomentOptions& theOptions)
  : measured(std::move(theMeasured))
  , options(theOptions)
{
}

PolarVolume MomentMaker::Make(MomentName moment)
{
  PolarVolume volume = this->MakeRaw(moment);
  Despeckle(volume, options.quality.neighbours);
  return volume;
}

PolarVolume MomentMaker::MakeRaw(MomentName moment)
{
  switch (moment)
  {
  case MomentName::VEL:
    if (options.dealias)
    {
      PolarVolume volume = this->Unfolded().folded;
      for (std::size_t i = 0; i < volume.sweeps.size(); ++i)
      {
        const VelocitySweep& sweep = velocities->unfolded.sweeps[i];
        if (!Holds(volume.sweeps[i], sweep))
        {
          SetGates(volume.sweeps[i], sweep.values, sweep.states);
        }
      }
      return volume;
    }
    return measured(moment, {});
  case MomentName::REF:
    return this->MakeReflectivity();
  case MomentName::SRV:
    return this->MakeStormRelative();
  case MomentName::AZSHEAR:
    return this->MakeDerived(moment, AzimuthalShear);
  case MomentName::DIV:
    return this->MakeDerived(moment, RadialDivergence);
  case MomentName::KDP:
    return MakePhaseSlopes(
      measured(MomentName::PHI, {}), measured(MomentName::REF, {}), measured(MomentName::RHO, {}));
  default:
    return measured(moment, {});
  }
}

PolarVolume MomentMaker::MakeReflectivity()
{
  PolarVolume volume = measured(MomentName::REF, {});
  if (options.quality.level == QualityLevel::Off)
  {
    return volume;
  }
  // Whoever makes many volumes makes them on threads of their own.
  const EchoClassification found = ClassifyEcho(volume, measured, ThreadLoop(1));
  TakeOut(volume, found, options.quality.level);
  volume.echo = GatesLeft(found.counts, options.quality.level);
  echo = found.counts;
  return volume;
}

const MomentMaker::Velocities& MomentMaker::Unfolded()
{
  if (!velocities)
  {
    velocities.emplace();
    velocities->folded = measured(MomentName::VEL, {});
    velocities->unfolded = MakeVelocityVolume(velocities->folded);
    Dealias(velocities->unfolded);
  }
  return *velocities;
}

PolarVolume MomentMaker::MakeStormRelative()
{
  const Velocities& found = this->Unfolded();
  const std::optional<Wind> motion =
    options.stormMotion ? options.stormMotion : EstimateStormMotion(found.unfolded);
  if (!motion && !found.folded.sweeps.empty())
  {
    note = "the velocities tell less than 2 km of the wind profile up to 6 km, so that SRV has no "
           "values: give the storm motion";
  }
  const double unknown = std::numeric_limits<double>::quiet_NaN();
  return this->MakeDerived(MomentName::SRV,
    [subtracted = motion.value_or(Wind{unknown, unknown})](VelocitySweep sweep)
    {
      SubtractMotion(sweep, subtracted);
      return sweep.values;
    });
}

PolarVolume MomentMaker::MakeDerived(
  MomentName moment, const std::function<std::vector<float>(const VelocitySweep&)>& valuesOf)
{
  const Velocities& found = this->Unfolded();
  PolarVolume volume = found.folded;
  volume.moment = moment;
  for (std::size_t i = 0; i < volume.sweeps.size(); ++i)
  {
    const VelocitySweep& sweep = found.unfolded.sweeps[i];
    SetGates(volume.sweeps[i], valuesOf(sweep), sweep.states);
  }
  return volume;
}

} // namespace nexrad
