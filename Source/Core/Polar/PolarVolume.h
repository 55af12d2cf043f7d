// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Model/RadarVolume.h"
#include "nexrad/Polar/GateCode.h"
#include "nexrad/Polar/GateRows.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace nexrad
{

/// Direction and time of one ray.
struct PolarRay
{
  float azimuth = 0.0F;          ///< degrees clockwise from north
  float elevation = 0.0F;        ///< degrees
  float unambiguousRange = 0.0F; ///< m; 0 when unknown
  Time time{};
  float nyquist = 0.0F; ///< m/s, Nyquist velocity; 0 when unknown
};

/// One moment of one sweep: a code for each gate (GateCode), rays × gates. All rays share one gate
/// geometry and one scale.
struct PolarSweep
{
  int elevationNumber = 0;  ///< number of the cut in the coverage pattern, from 1
  double firstGate = 0.0;   ///< m, slant range of the first gate's centre; may be negative
  double gateSpacing = 0.0; ///< m
  std::size_t gates = 0;    ///< of each ray
  std::vector<PolarRay> rays;
  GateScale scale; ///< of the codes
  GateRows rows;   ///< the codes, a row for each ray
  Waveform waveform = Waveform::Unknown;

  /// Reads the codes of a ray, as many as gates.
  void Read(std::size_t ray, std::uint16_t* codes) const { rows.Read(ray, gates, codes); }
};

/// Gates of reflectivity that quality control leaves in a volume.
struct EchoGates
{
  std::size_t all = 0; ///< with a value; 0 where it is off
  std::size_t biological = 0;
};

/// What gridding needs of a radar volume: one moment of one site.
struct PolarVolume
{
  Site site;
  MomentName moment = MomentName::REF;
  Time start{};                   ///< first ray, of the whole volume
  Time end{};                     ///< last ray
  bool synthetic = false;         ///< from a simulated file
  std::vector<PolarSweep> sweeps; ///< those that have the moment, in the order scanned
  EchoGates echo;                 ///< of reflectivity
  /// Degrees: of a volume whose last cuts are lost, the elevation of its last sweep.
  std::optional<double> endsAt = std::nullopt;
};

/// What a code says of its gate: Valid from GateCode::FirstValue on. Filtered gates are NotSampled:
/// no file has them.
GateState StateOf(std::uint16_t code);

/// Slant range in m up to which the gates of a sweep are wanted, by its elevation in degrees.
using WantedRange = std::function<double(double)>;

/// The gates of one measured moment, as the file has them: the code of a value is its word + 2, and
/// the scale that of the words. Where that cannot be (rays of one sweep differ in the scale of
/// their words, larger words are smaller values, or a word leaves no room for its code) the sweep's
/// values are rounded to a scale of their own (GateScale::Between): what is interpolated between
/// rays must have one scale.
///
/// A sweep whose rays differ in gate geometry gives one PolarSweep for each geometry; shorter rays
/// are padded with NotSampled, rays without the moment are left out. Values that no measurement can
/// give (ImpossibleGates) are NotSampled. Of REF, LimitReach is applied to each sweep. With
/// `wanted`, gates behind that range are left out, all but one, and rows can refer to the words of
/// the volume, which must outlive them (GateRows::AppendWords); an empty one wants all gates.
PolarVolume MakePolarVolume(
  const RadarVolume& volume, MomentName moment, const WantedRange& wanted = {});

/// Makes the polar volume of a measured moment, one without sweeps where there is none of it. It
/// may leave out the gates behind the wanted range; what is made with one is for use at once.
using MeasuredVolume = std::function<PolarVolume(MomentName, const WantedRange&)>;

/// Sets the gates of a sweep from numbers: the value and the state of each gate, rays × gates,
/// gates fastest. Values are rounded to GateScale::Between the least and the largest; those that
/// are not finite become NotSampled.
void SetGates(
  PolarSweep& sweep, const std::vector<float>& values, const std::vector<GateState>& states);

/// Of a sweep of reflectivity, takes what lies beyond the unambiguous range of its ray for not
/// scanned: a gate there that is below threshold becomes NotSampled. The pulses cannot tell that
/// nothing is there: its echo comes back after the next pulse. A gate with a value stays, since the
/// radar has moved it there from where it came back, and so does a folded one. Gates at the end of
/// the rays that are NotSampled on all of them are cut off. Sweeps of batch cuts (whose
/// reflectivity is that of long pulses, of a range that rays do not tell) and of unknown waveform
/// stay as they are, and so do rays without a range.
void LimitReach(PolarSweep& sweep);

/// Bytes that a volume takes in memory.
std::size_t MemoryOf(const PolarVolume& volume);

/// The elevation of a sweep: the median of its rays', degrees; 0 without rays (Formulas Q7).
double MedianElevation(const PolarSweep& sweep);

} // namespace nexrad
