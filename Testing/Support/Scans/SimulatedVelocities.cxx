// SPDX-License-Identifier: BSD-3-Clause
#include "Scans/SimulatedVelocities.h"

#include "nexrad/Model/SiteTable.h"
#include "nexrad/Simulation/RadarSimulator.h"

#include <cmath>
#include <cstddef>

namespace nexrad::testing
{

namespace
{

// Moves each velocity by whole folds to the true one.
void Unfold(const std::vector<RayTruth>& truth, VelocitySweep& sweep)
{
  for (std::size_t ray = 0; ray < sweep.rays.size(); ++ray)
  {
    const float whole = 2.0F * sweep.rays[ray].nyquist;
    const std::vector<float>& velocity = truth[ray].velocity;
    for (std::size_t gate = 0; gate < velocity.size(); ++gate)
    {
      float& value = sweep.values[sweep.Index(ray, gate)];
      value += whole * std::nearbyint((velocity[gate] - value) / whole);
    }
  }
}

} // namespace

SimulatedVelocities SimulateVelocities(const std::string& site, int pattern, bool superResolution)
{
  SimulatorOptions options;
  options.superResolution = superResolution;
  ScanTruth truth;
  SimulatedVelocities result;
  result.volume = ScanVolume(StormField(), {site, FindSite(site)->position}, pattern,
    *ParseIso8601("2006-03-12T18:30Z"), options, &truth);
  result.folded = MakeVelocityVolume(MakePolarVolume(result.volume, MomentName::VEL));
  result.truth = result.folded;
  std::size_t next = 0;
  for (std::size_t cut = 0; cut < result.volume.sweeps.size(); ++cut)
  {
    if (result.volume.sweeps[cut].Has(MomentName::VEL))
    {
      Unfold(truth.sweeps[cut], result.truth.sweeps.at(next++));
    }
  }
  return result;
}

PolarVolume PolarVelocities(const VelocityVolume& velocities, PolarVolume folded)
{
  for (std::size_t i = 0; i < folded.sweeps.size(); ++i)
  {
    SetGates(folded.sweeps[i], velocities.sweeps[i].values, velocities.sweeps[i].states);
  }
  return folded;
}

} // namespace nexrad::testing
