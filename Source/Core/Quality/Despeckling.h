// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Polar/PolarVolume.h"

namespace nexrad
{

/// The most neighbours that a gate can have.
constexpr int MostNeighbours = 26;

/// Takes out gates whose value stands nearly alone (Formulas Q3): those of which fewer than
/// `neighbours` neighbours have a value. Neighbours are the gates at the same, the previous and the
/// next ray and gate of the same sweep, and the nine gates nearest to it in the tilt below and in
/// the tilt above: of several cuts of that tilt, in the one that has the most values there. All
/// gates are judged by the volume as it was. A neighbour that is not there (below the lowest tilt,
/// beyond the last gate, across a gap between rays) has no value.
///
/// A gate that is taken out becomes Filtered: it carries no weight, and does not say that there
/// is no echo (Formulas Q5). Where it stood alone, its neighbours without echo fill its place.
///
/// Throws Error unless `neighbours` is 0…26.
void Despeckle(PolarVolume& volume, int neighbours);

} // namespace nexrad
