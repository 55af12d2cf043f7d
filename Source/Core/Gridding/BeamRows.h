// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Grid/GriddedVolume.h"
#include "nexrad/Grid/MomentCode.h"
#include "nexrad/Grid/SiteGeometry.h"
#include "nexrad/Gridding/BeamColumn.h"
#include "nexrad/Gridding/BeamSampling.h"
#include "nexrad/Gridding/BeamTilts.h"
#include "nexrad/Gridding/EchoMask.h"
#include "nexrad/Gridding/QuietTilts.h"
#include "nexrad/Gridding/SiteLayers.h"
#include "nexrad/Motion/MotionField.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace nexrad
{

/// One radar as it takes part in one merge.
struct MergeSite
{
  int number = 0; ///< among the radars of the merge, by which ancillary arrays name it
  Position position;
  std::vector<const BeamVolume*> volumes; ///< from which the rest is made
  SiteLevels levels;
  std::vector<BeamTilt> tilts;  ///< never empty
  std::vector<TiltEdges> edges; ///< of the tilts
  SamplingContext context;
  float reach =
    0.0F; ///< tan(γ/2) of the farthest gate of any observation; columns beyond it are not scanned
  std::array<double, 2> north = {0.0, 1.0}; ///< the radar's north in the grid's directions
  std::vector<QuietTilt> quiet = {};        ///< of the tilts
  std::uint8_t lowestQuiet = 0;             ///< the lowest QuietTilt::elevation
  QuietZones zones = {};                    ///< none where a radar's weight may be 0
  SiteLayers layers = {};                   ///< none unless they are followed
  EchoMask mask = {};                       ///< where echo is, or may move from or to
  EchoMask nearMask = {};                   ///< where echo is, or up to NearDistance away
  float since = 0.0F; ///< s from the farthest ray before the time that may be needed
  float until = 0.0F; ///< s to the farthest one after it

  static constexpr double NearDistance = 1'500.0; ///< m
};

/// A radar of a merge over the block that is made.
struct SiteOnBlock
{
  const MergeSite* site;
  const SiteGeometry* geometry;
};

/// What is done with the radars.
struct RowOptions
{
  VoxelBlock block; ///< of the grid, that is made
  int levels = 0;   ///< of the grid: a column is merged as a whole, whatever part of it is made
  OverlapStrategy strategy = OverlapStrategy::Distance;
  float overlapLength = 100'000.0F; ///< m
  bool fillColumns = false;
  bool trend = true;                   ///< BeamMergeOptions
  const MotionField* motion = nullptr; ///< over the grid; without, linear in time
  /// Of each column of the grid, x fastest, takes whether a radar gives an echo to any of its
  /// voxels; nullptr: nobody asks.
  std::uint8_t* echoes = nullptr;
  int width = 0;                  ///< columns of the grid along x
  std::optional<MomentCode> code; ///< of one byte: makes codes in place of values and states
};

/// Merges the rows [beginRow, endRow) of a grid that the block has: its columns (x, y) for these y.
/// `volume` has its fill value and arrays of the block's size, of which every value of these rows
/// is set; its ancillary arrays are made when they have their size. Ranges of rows write apart from
/// each other and can be run side by side. A voxel's value does not depend on the block. Returns
/// the states of these rows that codes do not tell, in no order.
std::vector<StateRun> MergeRows(const std::vector<SiteOnBlock>& sites, const RowOptions& options,
  int beginRow, int endRow, GriddedVolume& volume);

/// The same of the columns that `wanted` marks: it has a value for each column of the block, x
/// fastest. The others stay as they are.
void MergeColumns(const std::vector<SiteOnBlock>& sites, const RowOptions& options,
  const std::vector<std::uint8_t>& wanted, GriddedVolume& volume);

/// Marks the columns of the block, x fastest, whose voxels change when `before` become `after`, by
/// what these radars see at the same time: not 0. RowOptions::echoes is that of the merge with
/// those before: where no radar gives an echo, it does not matter how much those count that have
/// none.
std::vector<std::uint8_t> FindDifferences(const std::vector<SiteOnBlock>& before,
  const std::vector<SiteOnBlock>& after, const RowOptions& options, bool ancillary);

} // namespace nexrad
