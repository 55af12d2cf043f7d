// SPDX-License-Identifier: BSD-3-Clause
// Merges by beams of polar volumes, which tests have; BeamMerger takes volumes that are ready.
#pragma once

#include "nexrad/Gridding/BeamMerge.h"

namespace nexrad::testing
{

/// The volumes made ready for a merger's grid and options.
inline BeamVolumes PrepareAll(const BeamMerger& merger,
  const std::vector<const PolarVolume*>& volumes, const RangeLoop& loop = {})
{
  BeamVolumes ready(volumes.size());
  RunEach(loop, volumes.size(),
    [&](std::size_t i)
    {
      ready[i] = std::make_shared<const BeamVolume>(
        PrepareForGrid(*volumes[i], merger.Grid(), merger.Options()));
    });
  return ready;
}

/// The merge of the volumes at a time, without motion.
inline std::optional<GriddedVolume> MergePolar(BeamMerger& merger,
  const std::vector<const PolarVolume*>& volumes, Time time, const RangeLoop& loop = {},
  const Progress& progress = {})
{
  return merger.Merge(PrepareAll(merger, volumes, loop), time, nullptr, loop, progress);
}

} // namespace nexrad::testing
