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
  return *MergeDirectly(pointers, request);
}

std::optional<GriddedVolume> MergeDirectly(const std::vector<const PolarVolume*>& volumes,
  const MergeRequest& request, const Progress& progress, DirectRun* run)
{
  Catalogue catalogue;
  for (const PolarVolume* const& volume : volumes)
  {
    SeriesVolume description;
    description.input = static_cast<std::size_t>(&volume - volumes.data());
    description.start = volume->start;
    description.end = volume->end;
    catalogue.Of(volume->site).Put(description);
  }
  DirectRun once;
  DirectRun& kept = run != nullptr ? *run : once;
  std::vector<ReadyVolume> ready;
  for (const ChosenVolume& each :
    catalogue.ChosenAt(request.time, VolumeRuleOf(request), {MomentName::REF}))
  {
    const PolarVolume* const volume = volumes[each.volume->input];
    ReadyVolume& made = kept.ready[volume];
    if (!made.polar && !made.beam)
    {
      const std::shared_ptr<const PolarVolume> notOwned(std::shared_ptr<void>(), volume);
      made = MakeReady(notOwned, request);
    }
    ready.push_back(made);
  }
  return MergeVolumes(ready, request, progress, kept.merge);
}

} // namespace nexrad::testing
