// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <set>
#include <string>

namespace nexrad
{

/// What the echo of a simulated gate comes from.
enum class EchoKind : std::uint8_t
{
  None,                 ///< the gate has no value
  Weather,              ///< storms
  Clutter,              ///< fixed targets near the radar and on ridges
  AnomalousPropagation, ///< ground far away, to which the air bends the lowest beams
  Biological,           ///< insects and birds; also the weak clear-air return of every day
  Sun,                  ///< a spike of the sun's noise
  Interference,         ///< a spike of another transmitter
  TestPattern,          ///< rays that hold one value
  Speckle               ///< single gates of noise
};

/// "weather", "clutter", "propagation", "biological", "sun", "interference", "test-pattern",
/// "speckle"; "none".
const char* ToString(EchoKind kind);

/// The kinds that can be added to the storms: all but None and Weather.
const std::set<EchoKind>& AddableEchoKinds();

/// Kinds with commas between them, as "clutter,sun", or "all" for AddableEchoKinds. Throws Error
/// for a name that is none of them.
std::set<EchoKind> ParseEchoKinds(const std::string& text);

} // namespace nexrad
