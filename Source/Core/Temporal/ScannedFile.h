// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Temporal/SiteSeries.h"

#include <utility>
#include <vector>

namespace nexrad
{

/// What one input file holds.
struct ScannedFile
{
  std::vector<std::pair<Site, SeriesVolume>> volumes;
  std::vector<InputProblem> problems;
};

} // namespace nexrad
