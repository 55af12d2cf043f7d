// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Quality/EchoClass.h"

#include <nlohmann/json_fwd.hpp>

#include <iosfwd>
#include <string>

namespace nexrad::application
{

/// What quality control found in the reflectivity of a volume, as `info --json` prints it: gates
/// with a value, by class, by reason, and how many each level takes out.
nlohmann::ordered_json MakeEchoJson(const ReasonCounts& counts);

/// The same for people, in two lines: the classes and the reasons that some gate has.
void PrintEcho(const ReasonCounts& counts, std::ostream& out);

/// One line on what a level takes out of the gates that were counted.
std::string DescribeTakenOut(const ReasonCounts& counts, QualityLevel level);

} // namespace nexrad::application
