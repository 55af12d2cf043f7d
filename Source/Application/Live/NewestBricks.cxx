// SPDX-License-Identifier: BSD-3-Clause
#include "Live/NewestBricks.h"

#include "vtkNexradThreads.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace nexrad::application
{

NewestBricks::NewestBricks(
  LiveSeries& theSeries, std::filesystem::path thePath, const VolumeFiles& theWritten)
  : series(theSeries)
  , path(std::move(thePath))
  , written(theWritten)
{
}

Time NewestBricks::TimeFor(Time ray, Duration most) const
{
  constexpr Duration minute = std::chrono::minutes(1);
  const Duration farthest = std::max(minute, most);
  if (merge && ray <= merge->At() && merge->At() - ray <= farthest + minute)
  {
    return merge->At();
  }
  const Duration ahead = std::clamp(4 * wholeTook, minute, farthest);
  return TimeSteps(ray + ahead, ray + ahead + minute, minute).front();
}

bool NewestBricks::Make(Time time, const Progress& progress)
{
  const auto begin = std::chrono::steady_clock::now();
  if (merge && merge->At() == time && merge->Grid() == series.Grid())
  {
    PlannedMerge now = series.PlanAgain(*merge);
    if (now.KeepsVoxelsOf(*merge))
    {
      this->Renew(std::move(now));
      return true;
    }
  }
  merge.reset();
  bricks.reset();
  PlannedMerge whole = series.Plan(time);
  whole.NoteEchoes();
  NxvBandWriter file(path, series.Grid(), written.encoding);
  if (!whole.MergeBands(NxvBandWriter::Rows, PackInto(file), progress))
  {
    return false;
  }
  file.Commit();
  wholeTook = std::chrono::duration_cast<Duration>(std::chrono::steady_clock::now() - begin);
  bricks.emplace(path);
  merge.emplace(std::move(whole));
  return true;
}

void NewestBricks::Renew(PlannedMerge now)
{
  const std::vector<VoxelBlock> tiles = now.FindTiles(*merge, bricks->TileSize());
  bricks->Replace(
    tiles.size(),
    [&](std::size_t tile) { return now.MergeTile(*merge, tiles[tile], bricks->CellSize()); },
    vtkNexradRangeLoop());
  bricks->Write(path, now.Describe());
  merge.emplace(std::move(now));
}

} // namespace nexrad::application
