// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Quality/CleanVolume.h"

#include "nexrad/Quality/Despeckling.h"

namespace nexrad
{

PolarVolume MakeCleanVolume(
  const RadarVolume& volume, MomentName moment, const QualityOptions& options)
{
  PolarVolume clean = MakePolarVolume(volume, moment);
  Despeckle(clean, options.neighbours);
  return clean;
}

} // namespace nexrad
