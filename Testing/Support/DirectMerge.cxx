// SPDX-License-Identifier: BSD-3-Clause
#include "DirectMerge.h"

#include "nexrad/Series/ScanInputs.h"

#include <mutex>

namespace nexrad::testing
{

DirectMerge::DirectMerge(
  const std::vector<std::filesystem::path>& inputs, const MergeOptions& theOptions)
  : options(theOptions)
{
  std::mutex mutex;
  const auto collect =
    [&](const SeriesVolume&, const RadarVolume&, const std::shared_ptr<const PolarVolume>& volume)
  {
    const std::lock_guard<std::mutex> lock(mutex);
    volumes.push_back(volume);
  };
  scan = *ScanInputs(inputs, SeriesOptionsOf(options), collect);
}

GriddedVolume DirectMerge::At(Time time) const
{
  MergeRequest request = MergeRequestOf(options, {});
  request.grid = GridOf(options, scan.Positions(), scan.Range());
  request.time = time;
  std::vector<const PolarVolume*> pointers;
  for (const std::shared_ptr<const PolarVolume>& volume : volumes)
  {
    pointers.push_back(volume.get());
  }
  return *MergeVolumes(pointers, request);
}

} // namespace nexrad::testing
