// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace nexrad
{

/// What quality control takes out of reflectivity.
enum class QualityLevel : std::uint8_t
{
  Off,      ///< nothing
  Standard, ///< ground echo, spikes, receiver faults and speckle
  Strict    ///< the same, and biological echo
};

/// "off", "standard", "strict".
const char* ToString(QualityLevel level);

/// What is taken out of a volume before it is merged.
struct QualityOptions
{
  QualityLevel level = QualityLevel::Off; ///< see RemovesClass

  /// A gate with a value stays when as many of its 26 neighbours (ray, gate and tilt) have one;
  /// 0…26, 0 keeps all. See Despeckle.
  int neighbours = 0;

  bool operator==(const QualityOptions& other) const
  {
    return level == other.level && neighbours == other.neighbours;
  }
};

/// What the echo of a gate comes from, as quality control finds it. The numbers are those of the
/// `REF_class` arrays.
enum class EchoClass : std::uint8_t
{
  None,          ///< the gate has no value
  Weather,       ///< rain, snow, hail; also the debris of a tornado
  Ground,        ///< ground clutter and anomalous propagation
  Biological,    ///< birds and insects
  Spike,         ///< the sun or another transmitter
  ReceiverFault, ///< a ray that holds one value: a test pattern, a fault of the receiver
  Speckle        ///< a few gates alone
};
constexpr std::size_t EchoClassCount = 7;

/// The test that decided the class of a gate.
enum class EchoReason : std::uint8_t
{
  None,              ///< the gate has no value
  Plain,             ///< weather: no test found anything else
  StrongCore,        ///< weather: 45 dBZ or more, without clear signs of the ground
  MeltingLayer,      ///< weather: low ρ_hv in a layer between weather
  Debris,            ///< weather: low ρ_hv at a couplet of velocities (a tornado)
  GroundTexture,     ///< ground: rough reflectivity, still and narrow velocity (Formulas Q1)
  GroundRegion,      ///< ground: beside such gates, and like them
  GroundHeight,      ///< ground: gone in the tilt above (vertical test, Formulas Q1)
  GroundPolarimetry, ///< ground: what two polarisations measure (Formulas Q2)
  GroundFilter,      ///< ground: left over by the radar's clutter filter (Formulas Q4)
  FlightPolarimetry, ///< biological: what two polarisations measure (Formulas Q2)
  ClearAir,      ///< biological: weak, shallow and widespread about the radar, in one polarisation
  ConstantPower, ///< spike: one power at all ranges, unlike both neighbours (Formulas Q3)
  ConstantValue, ///< receiver fault: one value at all ranges (Formulas Q3)
  FewGates       ///< speckle: too few connected gates (Formulas Q3)
};
constexpr std::size_t EchoReasonCount = 15;

/// The class that a reason stands for.
EchoClass ClassOf(EchoReason reason);

/// "none", "weather", "ground", "biological", "spike", "receiver fault", "speckle".
const char* ToString(EchoClass echoClass);
/// Short names, as "ground texture".
const char* ToString(EchoReason reason);

/// Gates by reason.
using ReasonCounts = std::array<std::size_t, EchoReasonCount>;

} // namespace nexrad
