// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Simulation/SimulatedDay.h"
#include "nexrad/System/Progress.h"

#include <cstdint>
#include <filesystem>
#include <vector>

namespace nexrad::application
{

/// What was written.
struct SimulationReport
{
  std::vector<std::filesystem::path> files; ///< in the order of their starts
  std::uint64_t bytes = 0;
  Time begin{}; ///< of the first volume
  Time end{};   ///< of the last volume's period
};

/// The synthetic day from 18:00 UTC on, when its storms are at their height.
SimulatedDayOptions DemoDay(Duration length);

/// Writes the files of a synthetic storm day into a folder, which is made when it does not exist.
/// Works on as many volumes at a time as the machine has cores; every file appears whole or not at
/// all. `progress` is told from one thread at a time, and can stop the work: the files written so
/// far stay. Throws Error for options that cannot be met or a file that cannot be written.
SimulationReport WriteSimulatedFiles(const SimulatedDayOptions& options,
  const std::filesystem::path& folder, const Progress& progress = {});

} // namespace nexrad::application
