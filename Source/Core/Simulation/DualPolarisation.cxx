// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Simulation/DualPolarisation.h"

#include "nexrad/Simulation/BeamTrace.h"
#include "nexrad/Simulation/CounterNoise.h"
#include "nexrad/Simulation/StormPlane.h"

#include <algorithm>
#include <cmath>

namespace nexrad
{

namespace
{

constexpr double meltingDepth = 400.0; // m, half
constexpr double wettest = 48.0;       // dBZ, above which melting snow is not told from rain
constexpr double leastHail = 53.0;     // dBZ

// Numbers of the noise streams within a ray.
constexpr std::uint64_t differentialStream = 32U << 16;
constexpr std::uint64_t phaseStream = 33U << 16;
constexpr std::uint64_t correlationStream = 34U << 16;

// What hydrometeors are like, before noise.
struct Hydrometeors
{
  double differentialReflectivity = 0.0; // dB
  double correlation = 0.0;
  double specificPhase = 0.0; // degrees a km
};

Hydrometeors At(double height, double reflectivity)
{
  const double above = height - MeltingLevel;
  const bool isHail = reflectivity >= leastHail;
  const double phase = above < 0.0 ? SpecificPhaseOfRain(reflectivity) : 0.0;
  if (isHail)
  {
    return {0.3, 0.94, phase};
  }
  if (std::abs(above) < meltingDepth && reflectivity < wettest)
  {
    return {DifferentialReflectivityOfRain(reflectivity) + 1.0, 0.92, phase};
  }
  return above < 0.0 ? Hydrometeors{DifferentialReflectivityOfRain(reflectivity), 0.992, phase}
                     : Hydrometeors{0.3, 0.985, 0.0};
}

Hydrometeors MeanOverBeam(const BeamTrace& beam, double range, double reflectivity)
{
  Hydrometeors mean;
  for (const QuadratureNode& node : LayerNodes())
  {
    const double elevation = beam.Elevation() + node.position * beam.Sigma();
    const Hydrometeors here =
      At(beam.At(range, elevation).height + beam.SiteAltitude(), reflectivity);
    mean.differentialReflectivity += node.weight * here.differentialReflectivity;
    mean.correlation += node.weight * here.correlation;
    mean.specificPhase += node.weight * here.specificPhase;
  }
  return mean;
}

// A value of each noise: nearly normal, but for `uniform`.
struct GateNoise
{
  double differential;
  double phase;
  double correlation;
  double uniform;
};

// The less two polarisations agree, the noisier is what compares them.
PolarimetricGate MeasureWeather(const Hydrometeors& air, double phase, const GateNoise& noise)
{
  const double lost = 1.0 - air.correlation;
  return {air.differentialReflectivity + (0.25 + 5.0 * lost) * noise.differential,
    phase + (2.0 + 60.0 * lost) * noise.phase,
    std::min(air.correlation + (0.004 + 0.15 * lost) * noise.correlation, 1.0)};
}

PolarimetricGate MeasureOther(EchoKind kind, double phase, const GateNoise& noise)
{
  switch (kind)
  {
  case EchoKind::Clutter:
  case EchoKind::AnomalousPropagation:
    return {2.2 * noise.differential, phase + 60.0 * noise.phase,
      std::clamp(0.65 + 0.15 * noise.correlation, 0.25, 0.95)};
  case EchoKind::Biological:
    return {4.0 + 1.5 * noise.differential, phase + 40.0 + 15.0 * noise.phase,
      0.55 + 0.12 * noise.correlation};
  default:
    return {3.0 * noise.differential, 360.0 * noise.uniform, 0.22 + 0.58 * noise.uniform};
  }
}

} // namespace

double SpecificPhaseOfRain(double reflectivity)
{
  const double z = std::pow(10.0, std::min(reflectivity, leastHail) / 10.0);
  const double rate = std::pow(z / 300.0, 1.0 / 1.4);
  return std::pow(rate / 44.0, 1.0 / 0.822);
}

double DifferentialReflectivityOfRain(double reflectivity)
{
  constexpr double most = 3.5;
  const double z = std::max(reflectivity, 0.0);
  const double least = -0.50 + 2.50e-3 * z + 7.50e-4 * z * z;
  const double greatest = 0.68 - 4.81e-2 * z + 2.92e-3 * z * z;
  return std::clamp((least + greatest) / 2.0, 0.0, most);
}

std::vector<PolarimetricGate> MeasurePolarisation(const BeamTrace& beam, const GateLayout& layout,
  const std::vector<double>& reflectivity, const std::vector<EchoKind>& kinds, std::uint64_t key)
{
  std::vector<PolarimetricGate> gates(static_cast<std::size_t>(layout.gates));
  double phase = SystemPhase;
  for (std::size_t gate = 0; gate < gates.size(); ++gate)
  {
    if (!std::isfinite(reflectivity[gate]))
    {
      continue;
    }
    const GateNoise noise{Normal(key, differentialStream + gate), Normal(key, phaseStream + gate),
      Normal(key, correlationStream + gate), Uniform(key, phaseStream + gate)};
    if (kinds[gate] == EchoKind::Weather)
    {
      const Hydrometeors air =
        MeanOverBeam(beam, layout.Range(static_cast<int>(gate)), reflectivity[gate]);
      phase += 2.0 * air.specificPhase * layout.gateSpacing / 1'000.0;
      gates[gate] = MeasureWeather(air, phase, noise);
    }
    else
    {
      gates[gate] = MeasureOther(kinds[gate], phase, noise);
    }
    gates[gate].phase -= 360.0 * std::floor(gates[gate].phase / 360.0);
  }
  return gates;
}

} // namespace nexrad
