// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Model/RadarVolume.h"

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <iosfwd>
#include <vector>

namespace nexrad::application
{

/// A gate that the user asked for; each number counts from 0.
struct GateRequest
{
  std::size_t sweep = 0;
  std::size_t ray = 0;
  std::size_t gate = 0;
};

/// What is asked of a file beyond its sweeps and moments.
struct InfoRequest
{
  bool echo = false; ///< what quality control finds in the reflectivity
  std::vector<GateRequest> gates;
};

/// What `info --json` prints of one file: the schema is in Documentation/Formats/info.md. Gates
/// that the file does not have come back without moments.
nlohmann::ordered_json MakeInfoJson(const RadarVolume& volume, const InfoRequest& request);

/// The same for people: a few lines on the file, a table of its sweeps, the gates, the notes.
void PrintInfoTable(const RadarVolume& volume, const InfoRequest& request, std::ostream& out);

/// The same in one line: name, site, times, VCP, numbers of sweeps and rays.
void PrintInfoLine(const RadarVolume& volume, std::ostream& out);

/// The ray, or nullptr when the volume has none of these numbers.
const Ray* FindRay(const RadarVolume& volume, const GateRequest& request);

} // namespace nexrad::application
