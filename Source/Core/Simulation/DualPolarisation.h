// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Simulation/BeamTrace.h"
#include "nexrad/Simulation/EchoKind.h"
#include "nexrad/Simulation/ScanStrategy.h"

#include <cstdint>
#include <vector>

namespace nexrad
{

/// What a radar of two polarisations measures of a gate beside reflectivity, with noise.
struct PolarimetricGate
{
  double differentialReflectivity = 0.0; ///< dB
  double phase = 0.0;                    ///< degrees, 0…360
  double correlation = 0.0;              ///< ρ_hv
};

/// Specific differential phase of rain, degrees a km: that of the rain rate R(K) = 44·K^0.822 mm/h
/// (Ryzhkov et al. 2005) which Z = 300·R^1.4 has. `reflectivity` in dBZ; above 53 dBZ it is hail
/// that adds, and rain of 53 dBZ counts.
double SpecificPhaseOfRain(double reflectivity);

/// Differential reflectivity of rain, dB: the middle of the range that Park et al. (2009) give for
/// rain of a reflectivity in dBZ; at most 3.5 dB.
double DifferentialReflectivityOfRain(double reflectivity);

/// The system's own differential phase, degrees, which every gate has.
constexpr double SystemPhase = 60.0;

/// The gates of a ray that the beam points along. `reflectivity` in dBZ and `kinds` are those of
/// the layout's gates; `key` is that of the ray's noise.
///
/// - rain: DifferentialReflectivityOfRain, ρ_hv 0.992
/// - melting layer (within 400 m of MeltingLevel, weaker than 48 dBZ): 1 dB more, ρ_hv 0.92
/// - ice above it: 0.3 dB, ρ_hv 0.985
/// - hail (from 53 dBZ): 0.3 dB, ρ_hv 0.94
/// - clutter and anomalous propagation: 0 ± 2.2 dB, ρ_hv 0.65 ± 0.15, phase ± 60°
/// - insects and birds: 4 ± 1.5 dB, ρ_hv 0.55 ± 0.12, 40° ± 15° more of phase
/// - the sun, interference, speckle: noise; ρ_hv from 0.22 to 0.8
///
/// Weather is the mean over the beam's height. The phase grows along the ray by twice the
/// integral of SpecificPhaseOfRain below the melting level, from SystemPhase on; nothing is
/// attenuated.
std::vector<PolarimetricGate> MeasurePolarisation(const BeamTrace& beam, const GateLayout& layout,
  const std::vector<double>& reflectivity, const std::vector<EchoKind>& kinds, std::uint64_t key);

} // namespace nexrad
