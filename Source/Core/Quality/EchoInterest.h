// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Quality/GateEvidence.h"

namespace nexrad
{

/// How much the evidence of a gate speaks for an origin, each 0…1.
struct EchoInterest
{
  float ground = 0.0F;       ///< ground clutter and anomalous propagation
  float flight = 0.0F;       ///< birds and insects
  bool polarimetric = false; ///< ρ_hv and Z_DR count in it
};

/// Formulas Q1 and Q2. Everything that is known counts, with fixed weights.
EchoInterest InterestOf(const GateEvidence& evidence);

/// 0 at `from`, 1 at `to`, linear between and constant beyond.
inline float Ramp(float value, float from, float to)
{
  const float part = (value - from) / (to - from);
  return part < 0.0F ? 0.0F : (part > 1.0F ? 1.0F : part);
}

} // namespace nexrad
