// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Polar/PolarVolume.h"
#include "nexrad/Quality/QualityOptions.h"

namespace nexrad
{

/// MakePolarVolume, and what the options take out.
PolarVolume MakeCleanVolume(
  const RadarVolume& volume, MomentName moment, const QualityOptions& options);

} // namespace nexrad
