// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Model/RadarVolume.h"

#include <cstdint>

namespace nexrad
{

/// How values of a moment are put together.
struct ValueRule
{
  bool nearest = false;    ///< take the nearest instead of interpolating
  bool linear = false;     ///< values are interpolated as 10^(dBZ/10) (Formulas G5)
  bool zeroIsNone = false; ///< no echo counts as 0 dBZ against an echo (Formulas G8, A1)
  float period = 0.0F;     ///< of angles, in the moment's unit; 0: values are no angles

  /// The rule of a moment: velocity, also that relative to the storm, takes the nearest (as
  /// measured it is folded, and the Nyquist velocity differs from cut to cut; a mean of the two
  /// sides of a vortex is the velocity of neither), differential phase is an angle, the others are
  /// interpolated.
  static ValueRule Of(MomentName moment, bool linearReflectivity);
};

/// Codes of gates: four states without a value, and from FirstValue on values.
struct GateCode
{
  static constexpr std::uint16_t NoEcho = 0;      ///< scanned, and below threshold
  static constexpr std::uint16_t RangeFolded = 1; ///< an echo whose range is ambiguous
  static constexpr std::uint16_t NotSampled = 2;  ///< the ray does not reach the gate
  static constexpr std::uint16_t Filtered = 3;    ///< taken out by quality control (Formulas Q5)
  static constexpr std::uint16_t FirstValue = 4;
  static constexpr std::uint16_t Last = 65'535;
};

/// The code of a word of a moment whose words 0 and 1 are the codes of their states: files have no
/// words of NotSampled and Filtered.
constexpr std::uint16_t CodeOfWord(std::uint16_t word)
{
  return static_cast<std::uint16_t>(word + (word >= 2 ? GateCode::FirstValue - 2 : 0));
}

/// What the codes of values stand for: value = base + step × number, in the unit of the moment. The
/// number of a value is its code less 1: the words of files, from which numbers follow, have no
/// state Filtered.
struct GateScale
{
  float base = 0.0F;
  float step = 0.0F; ///< above 0, so that larger codes are larger values; 0 without any value

  static constexpr int FirstNumber = GateCode::FirstValue - 1;

  /// The value of a code from FirstValue on.
  float ValueOf(std::uint16_t code) const
  {
    return this->ValueOfNumber(static_cast<float>(code - 1));
  }
  /// The value of a number, or between two.
  float ValueOfNumber(float number) const { return base + step * number; }
  /// The code nearest to a value, from FirstValue on.
  std::uint16_t CodeOf(float value) const;

  /// A scale for numbers from `least` to `most`, both finite. Its step is a power of two, at most
  /// 1/32000 of the range and no less than what a float can tell apart there; each value is a
  /// multiple of it. Numbers that are such multiples themselves, as the halves of a dB that radars
  /// send, are kept exactly.
  static GateScale Between(float least, float most);
};

} // namespace nexrad
