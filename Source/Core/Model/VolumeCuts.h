// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Model/Time.h"

#include <cstdint>
#include <optional>
#include <string>
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

/// Whether a pattern, by its number, is one of Terminal Doppler Weather Radars: 80 (hazard) or 90
/// (monitor). They scan low cuts again in their own way.
constexpr bool IsTerminalPattern(int number)
{
  return number == 80 || number == 90;
}

/// What ended a volume.
enum class VolumeEnd : std::uint8_t
{
  Missing,   ///< nothing in the file: its last rays are lost, or still to come
  LastCut,   ///< the radar, behind the last cut of the pattern or of an unknown pattern
  Early,     ///< the radar, with cuts of the pattern left: AVSET, when nothing is to be seen higher
  NewVolume, ///< the radar broke it off and began the next one
};

/// "last cut", "early", "new volume"; "missing" when nothing ended it.
const char* ToString(VolumeEnd end);

/// The cuts of one volume by their elevation numbers, each list ascending.
struct VolumeCuts
{
  /// True when the radar ended the volume and nothing was lost.
  bool IsComplete() const { return end != VolumeEnd::Missing && missing.empty(); }

  std::optional<int> patternNumber;       ///< VCP, as the volume's rays say
  std::optional<CoveragePattern> pattern; ///< message 5 of that pattern
  std::optional<int> expected; ///< how many cuts the pattern has; of message 5, or where that is
                               ///< absent and rays are of message 1, of the published patterns
  std::vector<int> missing;    ///< lost, or left out of an excerpt
  bool excerpt = false; ///< the end is there, and fewer than half of the cuts before it: somebody
                        ///< chose them, and the others are not lost
  std::vector<int> notScanned; ///< left by the radar, which ended the volume before them
  std::vector<int> repeated;   ///< scanned, at an elevation below former ones: SAILS and MRLE
  VolumeEnd end = VolumeEnd::Missing;
  bool begun = false; ///< its first ray begins a volume
  Duration left{};    ///< what the radar, as fast as in the last sweep, would have needed for the
                      ///< rest of a volume that ends with the file; 0 when not known
};

/// Whether the radar broke off a volume to begin the next one: that begins before the radar can
/// have scanned half of what was left. `pause`: from the last ray to the first of the next volume.
constexpr bool IsBrokenOff(Duration left, Duration pause, bool nextIsBegun)
{
  return nextIsBegun && 2 * pause < left;
}

/// "cut 5", "cuts 5 and 6", "cuts 3 to 9", "cuts 3, 5 and 7 to 9" for ascending numbers.
std::string CutsText(const std::vector<int>& numbers);

/// What became of the pattern without loss, a line each: cuts that the radar scanned again, cuts
/// that it left out, and those that an excerpt is without.
std::vector<std::string> DescribeCuts(const VolumeCuts& cuts);

} // namespace nexrad
