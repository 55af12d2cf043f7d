// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace nexrad
{

/// Codes of gates: three states without a value, and from FirstValue on values.
struct GateCode
{
  static constexpr std::uint16_t NoEcho = 0;      ///< scanned, and below threshold
  static constexpr std::uint16_t RangeFolded = 1; ///< an echo whose range is ambiguous
  static constexpr std::uint16_t NotSampled = 2;  ///< the ray does not reach the gate
  static constexpr std::uint16_t FirstValue = 3;
  static constexpr std::uint16_t Last = 65'535;
};

/// What the codes of values stand for: value = base + step × code, in the unit of the moment.
struct GateScale
{
  float base = 0.0F;
  float step = 0.0F; ///< above 0, so that larger codes are larger values; 0 without any value

  /// The value of a code from FirstValue on.
  float ValueOf(std::uint16_t code) const { return this->ValueOf(static_cast<float>(code)); }
  /// The value between two codes.
  float ValueOf(float code) const { return base + step * code; }
  /// The code nearest to a value, from FirstValue on.
  std::uint16_t CodeOf(float value) const;

  /// A scale for numbers from `least` to `most`, both finite. Its step is a power of two, at most
  /// 1/32000 of the range and no less than what a float can tell apart there; each value is a
  /// multiple of it. Numbers that are such multiples themselves, as the halves of a dB that radars
  /// send, are kept exactly.
  static GateScale Between(float least, float most);

  bool operator==(const GateScale& other) const { return base == other.base && step == other.step; }
  bool operator!=(const GateScale& other) const { return !(*this == other); }
};

} // namespace nexrad
