// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Geometry/Beam.h"

#include <vector>

namespace nexrad
{

struct BeamSweep;

/// Deconvolves all echo above 0 dBZ in the sweeps of one volume of reflectivity in elevation
/// (Formulas G9): from the mean of Z over a beam of `beamWidth` degrees to the value in its middle.
/// The slopes to the neighbouring tilts say how the echo changes within the beam. These tilts are
/// the nearest below and above that are more than SameTilt away; of repeated cuts the one scanned
/// nearest in time. States stay, so that an echo may come out below 0 dBZ. A sweep that has a
/// neighbour gets a scale that leaves room for the changes.
void SharpenSweeps(std::vector<BeamSweep>& sweeps, double beamWidth, const BeamModel& beam);

} // namespace nexrad
