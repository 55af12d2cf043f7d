// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Gridding/SiteLayers.h"

#include <algorithm>

namespace nexrad
{

SiteLayers::SiteLayers(
  const std::vector<const BeamVolume*>& volumes, const std::vector<BeamTilt>& tilts, Time time)
  : gapCount(tilts.empty() ? 0 : tilts.size() - 1)
{
  constexpr float half = 300.0F; // s: a usual volume's length away, a volume counts half
  std::vector<float> sums(gapCount, 0.0F);
  for (const BeamVolume* volume : volumes)
  {
    const Time middle = volume->start + (volume->end - volume->start) / 2;
    Part part{volume->layers.get(), static_cast<float>((middle - time).count()) / 1000.0F, {}, {}};
    const float weight = 1.0F / (1.0F + part.seconds * part.seconds / (half * half));
    for (std::size_t gap = 0; gap < gapCount; ++gap)
    {
      part.gaps.push_back(volume->layers->FindGap(tilts[gap].elevation, tilts[gap + 1].elevation));
      part.shares.push_back(weight);
      sums[gap] += weight;
    }
    parts.push_back(std::move(part));
  }
  for (Part& part : parts)
  {
    for (std::size_t gap = 0; gap < gapCount; ++gap)
    {
      part.shares[gap] /= sums[gap];
    }
  }
  // A volume without layers counts in the sums, and need not be asked.
  const auto changesNothing = [](const Part& part)
  { return std::all_of(part.gaps.begin(), part.gaps.end(), [](int gap) { return gap < 0; }); };
  parts.erase(std::remove_if(parts.begin(), parts.end(), changesNothing), parts.end());
  for (const Part& part : parts)
  {
    const std::vector<std::uint32_t>& marks = part.layers->Marks();
    anyIn.resize(std::max(anyIn.size(), marks.size()));
    for (std::size_t cell = 0; cell < marks.size(); ++cell)
    {
      anyIn[cell] |= marks[cell] != 0 ? 1 : 0;
    }
  }
}

bool SiteLayers::Find(const ColumnDirection& column, const ColumnMotion* motion,
  std::vector<EchoLayers::Changes>& changes) const
{
  bool any = false;
  for (const Part& part : parts)
  {
    const std::uint32_t marked = part.layers->GapsAt(column);
    if (marked == 0)
    {
      continue;
    }
    const ColumnDirection direction =
      motion != nullptr ? DirectionAt(column, *motion, part.seconds) : column;
    const EchoLayers::Place place = part.layers->FindPlace(direction);
    if (!any)
    {
      changes.assign(gapCount, EchoLayers::Changes{});
      any = true;
    }
    for (std::size_t gap = 0; gap < gapCount; ++gap)
    {
      const int number = part.gaps[gap];
      if (number >= 0 && (marked >> number & 1U) != 0)
      {
        part.layers->Add(number, place, part.shares[gap], changes[gap]);
      }
    }
  }
  return any;
}

} // namespace nexrad
