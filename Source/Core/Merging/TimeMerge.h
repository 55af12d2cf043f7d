// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Grid/GriddedVolume.h"
#include "nexrad/Merging/MergeOptions.h"
#include "nexrad/Motion/MotionTracker.h"
#include "nexrad/Polar/PolarVolume.h"
#include "nexrad/Series/Catalogue.h"
#include "nexrad/System/Progress.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace nexrad
{

/// One merged volume that is asked for.
struct MergeRequest : MergeRules
{
  GridSpecification grid;
  Time time{};
  RangeLoop loop;                  ///< runs Beam's rows; empty: on this thread
  std::optional<VoxelBlock> block; ///< the part of the grid that is made, as it is in the whole
};

/// The merges that options ask for, but for grid and time. `loop` runs their rows.
MergeRequest MergeRequestOf(const MergeOptions& options, const RangeLoop& loop);

/// Grid and biases of a request as text: with Catalogue::MadeOf all that decides, beside the
/// options, what a merge makes.
std::string MergeText(const MergeRequest& request);

/// A moment of a volume in the form that a method takes; the other is empty.
struct ReadyVolume
{
  std::shared_ptr<const PolarVolume> polar; ///< for Thesis
  std::shared_ptr<const BeamVolume> beam;   ///< for Beam

  MomentName Moment() const { return beam ? beam->moment : polar->moment; }
  const std::string& RadarName() const { return beam ? beam->site.name : polar->site.name; }
};

/// Whether a request's merge searches reflectivity for its motion.
bool LooksForMotion(const MergeRequest& request, MomentName moment);

/// Makes a volume ready for a request, whatever its time. As long as the grid is not known, a
/// request without means does: the merge makes what is missing.
ReadyVolume MakeReady(
  const std::shared_ptr<const PolarVolume>& volume, const MergeRequest& request);

/// What merges at several times of one grid share: the radars' geometry, the means of volumes that
/// lacked them, and what their motion was found from. A run passes one object to all its merges,
/// one after the other; it changes no result.
class MergeRun
{
public:
  /// The merger for the request's grid and options: the one before, when they are the same.
  BeamMerger& MergerFor(const MergeRequest& request);
  /// The last one of these.
  const BeamMerger& Merger() const { return *merger; }

  /// The motion along which the request asks to interpolate between volumes that are ready; nullptr
  /// for none.
  std::shared_ptr<const MotionField> MotionFor(
    const BeamVolumes& volumes, const MergeRequest& request);

private:
  std::unique_ptr<BeamMerger> merger;
  std::unique_ptr<MotionTracker> tracker; // for the merger's grid
};

/// Merges volumes of any number of sites that were chosen for the time and made ready for this
/// request, or but for means. A site with none takes no part; without any, no voxel is scanned.
/// `memory` is a volume that is no longer needed: its arrays become those of the result. Empty when
/// `progress` asked to stop. Throws Error as the method does.
std::optional<GriddedVolume> MergeVolumes(const std::vector<ReadyVolume>& volumes,
  const MergeRequest& request, const Progress& progress, MergeRun& run, GriddedVolume memory = {});

/// The same of several moments, each merged from the volumes that are of it, as one volume.
std::optional<GriddedVolume> MergeMoments(const std::vector<ReadyVolume>& volumes,
  const std::vector<MomentName>& moments, const MergeRequest& request, const Progress& progress,
  MergeRun& run, GriddedVolume memory = {});

/// Takes rows of a merged volume, and returns what is no longer needed of it: its arrays become
/// those of the next rows.
using TakeBand = std::function<GriddedVolume(GriddedVolume band)>;

/// What merges of all moments at one time have in common, whatever part of the grid is made, by the
/// method beam.
class PlannedMerge
{
public:
  /// Of volumes that were chosen and made ready as for MergeMoments. The run is that of all merges
  /// of the grid, and must outlive the plan.
  PlannedMerge(const std::vector<ReadyVolume>& volumes, const std::vector<MomentName>& moments,
    const MergeRequest& request, MergeRun& run);
  /// Of other volumes, at the time of another plan and along the motion that was found for it.
  /// Radars whose volumes are the same are taken from there.
  PlannedMerge(const PlannedMerge& before, const std::vector<ReadyVolume>& volumes);

  /// Has merges note which columns have echo, by which fewer are merged when a radar changes: a
  /// byte of memory for each column of the grid and moment. Before the first merge.
  void NoteEchoes();

  /// Merges the request's block, or the grid, in bands of `rows` rows, from the first row to the
  /// last, so that nobody needs to hold the whole volume. False when `progress` asked to stop.
  bool MergeBands(int rows, const TakeBand& take, const Progress& progress);

  Time At() const { return request.time; }
  const GridSpecification& Grid() const { return request.grid; }
  /// Whether voxels that no changed volume reaches are those of the plan of which this one was
  /// made. Ancillary arrays number the radars: with them these must be the same.
  bool KeepsVoxelsOf(const PlannedMerge& before) const;

  /// The tiles of `size` columns along x and y in which the merge may differ from that of the plan
  /// of which this one was made.
  std::vector<VoxelBlock> FindTiles(const PlannedMerge& before, int size) const;
  /// What differs in one of them, in whole cells of `cell` columns along x and y; nothing where
  /// nothing does. All tiles must be merged before this plan is that before another one. Several
  /// threads may ask at a time for different tiles.
  std::optional<ChangedTile> MergeTile(
    const PlannedMerge& before, const VoxelBlock& tile, int cell);
  /// What the merged volume says of itself, without voxels.
  GriddedVolume Describe() const;

private:
  struct OfMoment
  {
    std::shared_ptr<const MotionField> motion; ///< of the plan
    BeamMergePlan plan;
  };

  std::vector<MomentName> moments;
  MergeRequest request;
  MergeRun* run;
  std::vector<OfMoment> planned; ///< for each moment
};

} // namespace nexrad
