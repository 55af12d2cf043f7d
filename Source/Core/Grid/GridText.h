// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Grid/GridSpecification.h"

#include <string>

namespace nexrad
{

/// A grid for a message: "64x64x32 voxels of 7187.5 x 7187.5 x 625 m about 38.81, -94.26", the
/// latitude and longitude of the projection's centre in degrees.
std::string GridText(const GridSpecification& grid);

} // namespace nexrad
