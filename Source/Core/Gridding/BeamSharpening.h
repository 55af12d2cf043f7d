// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Gridding/BeamSampling.h"
#include "Gridding/TiltEdges.h"

#include <vector>

namespace nexrad
{

/// Takes back what the width of the beam did to reflectivity over one column (Formulas G9).
///
/// A gate is the mean of Z over the beam, so that the strongest echo in it outweighs the rest:
/// above the top of a storm the beam still sees the storm, and a thin layer does not fill it. How
/// much a value in dBZ is changed follows from how steeply the echo rises or falls to the
/// neighbouring tilts. Values above 0 dBZ are changed alone; states stay, so that an echo may come
/// out below 0 dBZ.
///
/// `samples` has one of each tilt. Returns true with the new samples in `sharpened`; false when no
/// tilt has such an echo, and then `sharpened` means nothing.
bool SharpenTilts(const std::vector<TiltEdges>& edges, const TiltSample* samples,
  std::vector<TiltSample>& sharpened);

} // namespace nexrad
