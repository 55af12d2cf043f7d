// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Calibration/RadarBiases.h"
#include "nexrad/Model/RadarVolume.h"

#include <nlohmann/json_fwd.hpp>

#include <iosfwd>
#include <string>

namespace nexrad::application
{

/// Adds what the volumes in a file have near the ground (LowEcho), for CompareRadars. Volumes
/// without reflectivity, a name or a position add nothing.
void AddLowEchoes(const RadarVolume& file, LowEchoes& echoes);

/// Prints the comparison of radars and what was taken off; nothing when there is no comparison.
void PrintBiases(const BiasReport& report, const RadarBiases& takenOff, std::ostream& out);

/// The same for programs: Documentation/Formats/grid.md has the keys.
nlohmann::ordered_json MakeBiasJson(const BiasReport& report, const RadarBiases& takenOff);

/// What the comparison says of one radar: its `bias_db`, and the `neighbours` that it was compared
/// with (Documentation/Formats/info.md).
void AddBiasOf(const std::string& radar, const BiasReport& report, nlohmann::ordered_json& object);

} // namespace nexrad::application
