// SPDX-License-Identifier: BSD-3-Clause
// What a forecaster reads off a volume: how high the echoes reach and where the cores stand.
#pragma once

#include "ScannedDay.h"
#include "nexrad/Grid/GriddedVolume.h"

#include <cstddef>

namespace nexrad::testing
{

/// Heights of 18 dBZ (Formulas P2), over the columns in which truth and result both reach it in
/// voxels that some beam saw.
struct EchoTopScore
{
  std::size_t columns = 0;
  double meanError = 0.0;         ///< m, result − truth
  double meanAbsoluteError = 0.0; ///< m
};
EchoTopScore CompareEchoTops(const GriddedVolume& result, const Truth& truth);

/// How far the cores of the result stand from the true ones. A core is a column whose maximum is 50
/// dBZ or more and the largest within 15 km; it is found when the result's largest column maximum
/// within 10 km of it is at least 45 dBZ.
struct CoreScore
{
  std::size_t cores = 0;
  std::size_t found = 0;
  double meanDistance = 0.0; ///< m, of those found
};
CoreScore CompareCores(const GriddedVolume& result, const Truth& truth);

} // namespace nexrad::testing
