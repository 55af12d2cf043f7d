// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Calibration/LowEcho.h"
#include "nexrad/Calibration/RadarBiases.h"

#include <memory>
#include <vector>

namespace nexrad
{

/// What volumes of several radars have near the ground.
using LowEchoes = std::vector<std::shared_ptr<const LowEcho>>;

/// Compares the radars of some volumes with each other (Formulas Q6). The order of the volumes
/// makes no difference.
///
/// - Two radars are compared in cells of LowEcho that lie at the same place, in the same layer of
///   height, as far from one radar as from the other: the ratio of the distances is 0.8 to 1.25.
///   Both values must be above 15 dBZ.
/// - A volume is compared with the one of the other radar that is nearest to it in time, when it is
///   the nearest to that one too, and their times (LowEcho::MeanTime) differ by five minutes at
///   most. Echo is not moved from one time to the other.
/// - Of one radar the report is empty.
/// - Radars without a name are not compared: a bias could not be given to them.
BiasReport CompareRadars(const LowEchoes& volumes);

} // namespace nexrad
