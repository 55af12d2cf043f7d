// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Quality/GateEvidence.h"

#include <vector>

namespace nexrad
{

/// What the evidence of each gate of a row speaks for.
struct InterestRow
{
  std::vector<float> ground;     ///< 0…1: ground clutter and anomalous propagation
  std::vector<float> notWeather; ///< 0…1: whatever is not weather, of two polarisations
  /// The mean ρ_hv that targets with a Z_DR of 0 dB have at the same depolarisation ratio; 1 where
  /// it is unknown.
  std::vector<float> roundCorrelation;
};

/// Formulas Q1 and Q2. Everything that is known counts, with fixed weights.
void FindInterest(const EvidenceRow& evidence, InterestRow& interest);

} // namespace nexrad
