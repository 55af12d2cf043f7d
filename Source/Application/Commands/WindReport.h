// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Velocity/Dealiasing.h"
#include "nexrad/Velocity/WindProfile.h"

#include <nlohmann/json_fwd.hpp>

#include <iosfwd>
#include <string>

namespace nexrad::application
{

/// The wind profile of one volume, and how it was dealiased.
struct WindReport
{
  std::string file;
  Site site;
  Time start{};
  Time end{};
  bool synthetic = false;
  DealiasCounts counts;
  WindProfile profile;
};

/// What `wind --json` prints of one volume: Documentation/Formats/wind.md has the schema.
nlohmann::ordered_json MakeWindJson(const WindReport& report);

/// The same for people: three lines on the volume, and a table of its levels, the highest first.
void PrintWindTable(const WindReport& report, std::ostream& out);

} // namespace nexrad::application
