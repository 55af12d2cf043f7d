// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Grid/GriddedVolume.h"
#include "nexrad/Model/Moment.h"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace nexrad::testing
{

/// What a run of the program left behind.
struct ProgramRun
{
  int status = -1; ///< exit status; -1 when a signal ended it
  std::string output;
  std::string errors;
  std::size_t peakMemory = 0; ///< largest resident memory, bytes
};

/// Runs a program with these arguments, each passed as it is.
ProgramRun RunProgram(const std::string& program, const std::vector<std::string>& arguments);

/// The same, and sends the program a signal as soon as `now` is true, when it still runs then.
ProgramRun InterruptProgram(const std::string& program, const std::vector<std::string>& arguments,
  const std::function<bool()>& now, int signal);

/// Where the program nexrad3d of this build stands.
std::string Nexrad3dPath();

/// Runs the program nexrad3d of this build with these arguments, each passed as it is.
ProgramRun RunNexrad3d(const std::vector<std::string>& arguments);

/// The only .nxv file of a folder, all its moments or one; a failure where there is none.
GriddedVolume ReadOnlyVolume(
  const std::filesystem::path& folder, std::optional<MomentName> moment = {});

} // namespace nexrad::testing
