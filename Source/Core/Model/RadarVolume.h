// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Model/Moment.h"
#include "nexrad/Model/Site.h"
#include "nexrad/Model/Time.h"
#include "nexrad/Model/VolumeCuts.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace nexrad
{

/// Where in the scan a radial stands (ICD 2620002, radial status), other than within a cut, which
/// is 1.
namespace RadialStatus
{
constexpr std::uint8_t StartOfCut = 0;
constexpr std::uint8_t EndOfCut = 2;
constexpr std::uint8_t StartOfVolume = 3;
constexpr std::uint8_t EndOfVolume = 4;
constexpr std::uint8_t StartOfLastCut = 5;
} // namespace RadialStatus

/// One radial: what the antenna saw in one direction.
struct Ray
{
  Time time{};                   ///< collection time, UTC
  float azimuth = 0.0F;          ///< degrees clockwise from north, centre of the beam, 0…360
  float elevation = 0.0F;        ///< degrees above the horizon, centre of the beam, −10…90
  float nyquist = 0.0F;          ///< m/s, Nyquist velocity; 0 when the file has none
  float unambiguousRange = 0.0F; ///< m, c·PRT/2: echo from beyond comes back after the next pulse.
                                 ///< In a batch cut that of the pulses that measure velocity. 0
                                 ///< when unknown
  std::uint8_t radialStatus = 1; ///< 1 within a cut, or one of RadialStatus
  std::uint8_t elevationNumber = 0; ///< number of the cut in the coverage pattern, from 1
  std::array<MomentRow, MomentCount> moments;

  /// The row of a measured moment.
  const MomentRow& Row(MomentName name) const { return moments[static_cast<std::size_t>(name)]; }
  MomentRow& Row(MomentName name) { return moments[static_cast<std::size_t>(name)]; }
};

/// One antenna cut: the rays of one turn (or part of a turn), in the order scanned.
struct Sweep
{
  int elevationNumber = 0;               ///< number of the cut in the coverage pattern, from 1
  std::vector<Ray> rays;                 ///< never empty in a decoded volume
  Waveform waveform = Waveform::Unknown; ///< ResolveWaveforms sets it

  /// Mean elevation angle of the rays, degrees; 0 without rays.
  double MeanElevation() const;
  /// The elevation of the cut: the median of the rays' angles, degrees; 0 without rays (Formulas
  /// Q7).
  double MedianElevation() const;
  /// The rays that stray from the cut (Formulas Q7); `beamWidth` in degrees.
  std::vector<const Ray*> StrayRays(double beamWidth) const;
  /// True when some ray has gates of the moment, or of the one that a derived moment is made of.
  bool Has(MomentName name) const;
};

/// The cut of a pattern that has the number of a sweep; nullptr where there is none, or where its
/// elevation is half a degree or more from that of the sweep.
const CoverageCut* FindCut(const CoveragePattern& pattern, const Sweep& sweep);

/// Something wrong in a file. The rest of the file was read.
struct Damage
{
  std::uint64_t offset = 0;  ///< byte offset in the file as it is stored (not as decompressed)
  std::string what;          ///< one line: what is wrong there
  bool isMissingEnd = false; ///< the file ends before the radar ended its last volume
};

/// What the radar says of itself (message 2).
struct RadarStatus
{
  int coveragePatternNumber = 0; ///< VCP; 0 when none was chosen
  double softwareBuild = 0.0;    ///< of the radar's software, for example 19.1
};

/// All that one Level II file, or one folder of chunks, holds. Rays point into `buffers`, which
/// copies of the volume share; the words never move.
struct RadarVolume
{
  std::string file; ///< path as the user gave it
  Site site;
  std::optional<int> coveragePatternNumber; ///< VCP, from the rays, else from message 5, else 2
  std::optional<CoveragePattern> coveragePattern; ///< message 5, when the file has one
  std::optional<RadarStatus> status;              ///< message 2, the last
  std::optional<int> messageType;                 ///< 1 or 31; empty without rays
  std::optional<Time> headerTime;       ///< time in the volume header; may differ from the rays'
  std::optional<double> storedAltitude; ///< m, of the antenna as the file has it, where that cannot
                                        ///< be and `site` has another; empty otherwise
  std::vector<Sweep> sweeps;            ///< in the order scanned
  std::vector<VolumeCuts> cuts; ///< of each volume in the file, in the order of SplitCycles; empty
                                ///< in a volume that was not decoded
  bool complete = false;  ///< the radar ended the last volume of the file, and no cut was lost
  bool synthetic = false; ///< the file says that it was simulated (IsSyntheticMark)
  std::vector<Damage> damage;
  std::vector<std::string> notes; ///< worth knowing, and not damage
  std::vector<std::shared_ptr<const std::vector<std::uint8_t>>> buffers; ///< decompressed records

  std::size_t RayCount() const;
  /// Times of the earliest first and the latest last ray of the sweeps; empty without rays.
  std::optional<Time> Start() const;
  std::optional<Time> End() const;
};

/// True when a sweep begins a new cycle: its first ray has radial status 3, the sweep before it
/// ends with radial status 4, or its cut number is lower than that sweep's, because both rays may
/// be missing.
bool BeginsCycle(const Sweep& before, const Sweep& sweep);

/// Cuts a volume that holds several cycles under one header into one volume a cycle. Each keeps the
/// buffers that its rays point into, and has its own cuts and coverage pattern; damage and notes,
/// which are the file's, stay with the first.
std::vector<RadarVolume> SplitCycles(const RadarVolume& volume);

/// Whether the last volume of a file has no end, so that the file behind it may tell why.
bool LacksEnd(const RadarVolume& volume);

/// Where the radar broke that volume off (IsBrokenOff) and began `next`, of another file: takes the
/// missing end out of the damage, and the cuts that follow out of those that are missing; a note
/// says what became of them.
void EndWithNext(RadarVolume& volume, const RadarVolume& next);

} // namespace nexrad
