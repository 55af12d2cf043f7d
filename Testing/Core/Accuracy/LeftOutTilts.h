// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "TiltSchemes.h"

#include <array>
#include <cstddef>
#include <vector>

namespace nexrad
{

/// Errors of foretold gates, dB.
struct GateErrors
{
  double squares = 0.0; ///< of gates that measured or are foretold as 10 dBZ or more
  double sum = 0.0;
  std::size_t gates = 0;
  double sumOfForetold = 0.0; ///< of gates that are foretold as 10 dBZ or more
  std::size_t gatesForetold = 0;
  double sumOfEcho = 0.0; ///< of gates where either is above 0 dBZ
  std::size_t gatesWithEcho = 0;

  void Add(double foretold, double measured);
  double Rmse() const;
  double Bias() const;           ///< of the gates of Rmse
  double BiasOfForetold() const; ///< of the gates that are foretold as 10 dBZ or more
  double BiasOfEcho() const;     ///< of all gates with echo
};

/// Of one scheme: judged by its value in the middle of the gate, and by the mean of Z over the
/// beam.
struct SchemeErrors
{
  GateErrors point;
  GateErrors beam;
};

/// A volume without one tilt, and the tilt.
struct LeftOutTilt
{
  PolarVolume others;
  PolarSweep measured;   ///< of a split cut, the half that scanned first
  double highest = 0.0;  ///< degrees, of the tilt above, with its beam's upper half
  double farthest = 0.0; ///< m, slant range of the gates that count: 100 km, or up to 18 km high
};

/// Leaves out each tilt between the lowest and the highest in turn.
std::vector<LeftOutTilt> LeaveTiltsOut(const PolarVolume& whole);

/// The first sweep of each tilt.
std::vector<SortedTilt> SortTilts(const PolarVolume& volume);

/// Adds the errors of schemes to those of each, over the gates that all of them foretell: from 20
/// km to the farthest, at most one for a kilometre of range and for a degree of azimuth.
void AddErrors(const LeftOutTilt& tilt, const std::vector<const TiltScheme*>& schemes,
  std::vector<SchemeErrors>& errors);

} // namespace nexrad
