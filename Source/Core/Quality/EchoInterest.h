// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Quality/Evidence/GateEvidence.h"

#include <vector>

namespace nexrad
{

/// How much the evidence of each gate of a row speaks for an origin, 0…1.
struct InterestRow
{
  std::vector<float> ground; ///< ground clutter and anomalous propagation
  std::vector<float> flight; ///< birds and insects
};

/// Formulas Q1 and Q2. Everything that is known counts, with fixed weights.
void FindInterest(const EvidenceRow& evidence, InterestRow& interest);

} // namespace nexrad
