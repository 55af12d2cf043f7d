// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace nexrad
{

/// What a radar measures at a gate, and what is derived from that. The first seven, the measured
/// ones, are the moments of a Level II ray; no ray has a row of a derived one. The derived ones are
/// made of a whole volume (MomentMaker); all of what is merged, stored and drawn knows both alike.
enum class MomentName : std::uint8_t
{
  REF, ///< reflectivity, dBZ
  VEL, ///< radial velocity, m/s, away from the radar positive
  SW,  ///< spectrum width, m/s
  ZDR, ///< differential reflectivity, dB
  PHI, ///< differential phase, degrees
  RHO, ///< correlation coefficient, without dimension
  CFP, ///< clutter filter power removed, dB

  SRV,     ///< radial velocity relative to the storm, m/s, away from the radar positive
  AZSHEAR, ///< azimuthal shear, 1/s, positive where air turns anticlockwise
  DIV,     ///< radial divergence, 1/s, positive where air flows apart
  KDP      ///< specific differential phase, degrees/km
};
/// The measured moments: those of rays.
constexpr std::size_t MomentCount = 7;
constexpr std::array<MomentName, MomentCount> AllMoments = {MomentName::REF, MomentName::VEL,
  MomentName::SW, MomentName::ZDR, MomentName::PHI, MomentName::RHO, MomentName::CFP};
/// The measured moments and the derived ones, by their numbers.
constexpr std::size_t KnownMomentCount = 11;
constexpr std::array<MomentName, KnownMomentCount> KnownMoments = {MomentName::REF, MomentName::VEL,
  MomentName::SW, MomentName::ZDR, MomentName::PHI, MomentName::RHO, MomentName::CFP,
  MomentName::SRV, MomentName::AZSHEAR, MomentName::DIV, MomentName::KDP};

/// Whether rays have the moment.
constexpr bool IsMeasured(MomentName name)
{
  return static_cast<std::size_t>(name) < MomentCount;
}
/// The measured moment that a moment is made of: VEL for SRV, AZSHEAR and DIV; PHI for KDP; a
/// measured moment itself.
MomentName MeasuredFor(MomentName name);
/// Whether values are a component of the wind along the beam, m/s: VEL and SRV. They depend on the
/// direction from the radar.
constexpr bool IsRadialVelocity(MomentName name)
{
  return name == MomentName::VEL || name == MomentName::SRV;
}
/// Whether values lie to both sides of 0 and the strongest is that farthest from 0: VEL, SRV,
/// AZSHEAR and DIV.
constexpr bool HasTwoSigns(MomentName name)
{
  return IsRadialVelocity(name) || name == MomentName::AZSHEAR || name == MomentName::DIV;
}

/// "REF", "VEL", …: also the name of the moment's array in VTK.
const char* ToString(MomentName name);
/// Unit of the values: "dBZ", "m/s", "m/s", "dB", "degrees", "", "dB"; "m/s", "1/s", "1/s",
/// "degrees/km".
const char* UnitOf(MomentName name);
/// Digits behind the point that a value is written with: 1; 3 for RHO, 4 for AZSHEAR and DIV, 2 for
/// KDP.
int DigitsOf(MomentName name);
/// What the moment is called in words: "Reflectivity", "Radial velocity", …
const char* TitleOf(MomentName name);
/// Empty when the text names no moment, measured or derived. Capital letters only.
std::optional<MomentName> ParseMomentName(std::string_view text);
/// Moments with commas between them, as "REF,VEL". Empty when the text is anything else, and when
/// it names a moment twice.
std::vector<MomentName> ParseMomentNames(std::string_view text);
/// All names for an error message: "REF, VEL, SW, ZDR, PHI, RHO or CFP, or the derived SRV,
/// AZSHEAR, DIV or KDP".
std::string MomentNameList();

/// What a gate holds. The numbers are those of the `<NAME>_state` arrays.
enum class GateState : std::uint8_t
{
  Valid = 0,
  BelowThreshold = 1, ///< scanned, and no echo above the noise (for CFP: a status code)
  RangeFolded = 2,    ///< an echo whose range is ambiguous
  NotSampled = 3      ///< the ray does not reach this gate, or lacks the moment
};

/// One moment along one ray: the words as the radar wrote them, converted when asked.
/// It does not own the words; they belong to the RadarVolume that holds the ray.
struct MomentRow
{
  static constexpr std::size_t MostGates = 65'535;

  const std::uint8_t* words = nullptr; ///< big-endian words of wordBits each
  std::uint16_t gates = 0;             ///< number of gates; 0: the ray lacks the moment
  std::uint8_t wordBits = 8;           ///< 8 or 16
  std::uint8_t firstValue = 2;         ///< raw words below are codes (2; 8 for CFP)
  std::int32_t firstGate = 0;   ///< m, slant range of the first gate's centre; may be negative
  std::int32_t gateSpacing = 0; ///< m, between centres of gates
  float scale = 1.0F;           ///< value = (raw - offset) / scale
  float offset = 0.0F;

  /// True when another row has as many gates, at the same ranges.
  bool HasGatesOf(const MomentRow& other) const
  {
    return gates == other.gates && firstGate == other.firstGate && gateSpacing == other.gateSpacing;
  }
  /// The word of a gate, gate < gates.
  unsigned Raw(std::size_t gate) const
  {
    return wordBits == 16 ? static_cast<unsigned>(words[2 * gate] << 8 | words[2 * gate + 1])
                          : words[gate];
  }
  GateState State(std::size_t gate) const
  {
    const unsigned raw = this->Raw(gate);
    if (raw >= firstValue)
    {
      return GateState::Valid;
    }
    return raw == 1 && firstValue == 2 ? GateState::RangeFolded : GateState::BelowThreshold;
  }
  /// The value of a valid gate in the unit of the moment; without meaning for other gates.
  float Value(std::size_t gate) const { return this->ValueOf(this->Raw(gate)); }
  /// The same of a word.
  float ValueOf(unsigned raw) const { return (static_cast<float>(raw) - offset) / scale; }
};

} // namespace nexrad
