// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Quality/Evidence/GateEvidence.h"

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

} // namespace nexrad
