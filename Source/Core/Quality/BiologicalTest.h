// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Quality/SweepJudgement.h"

#include <cstddef>
#include <vector>

namespace nexrad
{

/// Finds the birds and insects of a sweep with dual polarisation: connected regions of gates with
/// signs of flight, three in ten of which are sure, and above three quarters of which there is no
/// echo at 4 km (Formulas Q2). Sets the reasons of these gates to FlightPolarimetry, but of those
/// under such echo. `sweeps`: all of the volume.
void FindFlight(const std::vector<SweepJudgement>& sweeps, SweepJudgement& sweep);

/// Finds the clear-air echo of a sweep without dual polarisation: weak weather (below 20 dBZ) above
/// which there is no echo at 3 km, nor in the tilt above, in connected regions that reach within 40
/// km of the radar. 300 km² and more of a region, and a quarter of it, lie where the beam is up to
/// 2.5 km high. Sets the reasons of these gates to ClearAir. `sweeps`: all of the volume.
void FindClearAir(const std::vector<SweepJudgement>& sweeps, SweepJudgement& sweep);

} // namespace nexrad
