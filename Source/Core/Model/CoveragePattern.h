// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

namespace nexrad
{

/// Waveform of a cut, as message 5 numbers it (ICD 2620002, table XI).
enum class Waveform : std::uint8_t
{
  Unknown = 0,
  ContiguousSurveillance = 1,   ///< long range, reflectivity
  ContiguousDoppler = 2,        ///< with ambiguity resolution
  ContiguousDopplerWithout = 3, ///< without ambiguity resolution
  Batch = 4,                    ///< both in one cut
  StaggeredPulsePair = 5
};

/// One elevation cut of a volume coverage pattern.
struct CoverageCut
{
  double elevation = 0.0; ///< degrees
  Waveform waveform = Waveform::Unknown;
  bool superResolution = false; ///< half-degree azimuths
  double azimuthRate = 0.0;     ///< degrees a second; 0 when unknown
};

/// The cuts of a volume, in the order scanned.
struct CoveragePattern
{
  int number = 0; ///< VCP
  std::vector<CoverageCut> cuts;
};

} // namespace nexrad
