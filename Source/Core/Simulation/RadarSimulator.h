// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Model/RadarVolume.h"
#include "nexrad/Simulation/EchoKind.h"
#include "nexrad/Simulation/ScanStrategy.h"
#include "nexrad/Simulation/StormField.h"

#include <cstdint>
#include <set>
#include <vector>

namespace nexrad
{

/// What is true of the gates of one simulated ray.
struct RayTruth
{
  /// Of each gate of VEL: the radial velocity before noise and folding, m/s, positive away from the
  /// radar. NaN where the word is no velocity (no echo, range folded) and where the echo has none
  /// (the sun, interference, a test pattern, speckle). Empty without VEL.
  std::vector<float> velocity;
  /// Of each gate of REF: what its echo, the strongest of several, comes from; None where the word
  /// is no value. Empty without REF.
  std::vector<EchoKind> reflectivityKinds;
  /// The same of each gate of VEL; a range-folded gate has the kind of the echo at its own range.
  std::vector<EchoKind> velocityKinds;
};

/// What is true of the gates of a simulated volume: `sweeps[s][r]` is about the ray
/// `sweeps[s].rays[r]` of the RadarVolume.
struct ScanTruth
{
  std::vector<std::vector<RayTruth>> sweeps;
};

struct SimulatorOptions
{
  bool superResolution = false; ///< 250 m × 0.5° (message 31) in place of 1 km × 1° (message 1)
  double effectiveRadiusFactor =
    4.0 / 3.0;             ///< refraction of the simulated atmosphere (Formulas B1)
  double beamWidth = 0.95; ///< degrees, between half-power points
  double noise = 1.0;      ///< dB, standard deviation of a gate's reflectivity
  double sensitivity =
    -7.5;                 ///< dBZ, weakest echo seen at 50 km; it rises with 20·log10 of the range
  std::uint32_t seed = 1; ///< of the noise
  std::set<EchoKind> notWeather; ///< of AddableEchoKinds: echo added to the storms (AddedEcho);
                                 ///< by default none
  double bias = 0.0;             ///< dB that every reflectivity is too high
  bool dualPolarisation = false; ///< ZDR, PHI and RHO (MeasurePolarisation) in the cuts that have
                                 ///< them in real files; message 31 alone
};

/// Weakest reflectivity that the radar sees at a slant range in m, dBZ.
double SensitivityAt(double range, const SimulatorOptions& options);

/// Scans the field with one radar, one coverage pattern, from `start` on: each gate is the mean of
/// the field over the beam and the gate's length at the ray's own time (BeamSampler). Velocity is
/// the mean of the wind's component along the beam, weighted with Z (VelocitySampler), folded at
/// the Nyquist velocity; echoes of two pulses that overlie each other are range folded, unless one
/// is 5 dB stronger. The volume is marked synthetic and has its coverage pattern. Deterministic:
/// the noise of a gate depends on the seed, the site, `start` and the gate alone. `truth`, where
/// given, takes what is true of each gate: the volume is the same with it and without. Throws Error
/// for an unknown pattern, a site without a position, an option that is not above zero, or dual
/// polarisation without super-resolution.
RadarVolume ScanVolume(const StormField& field, const Site& site, int coveragePattern, Time start,
  const SimulatorOptions& options = {}, ScanTruth* truth = nullptr);

/// Time from the start of one volume to the start of the next with that pattern. Throws Error for
/// an unknown pattern.
Duration VolumePeriod(int coveragePattern);

} // namespace nexrad
