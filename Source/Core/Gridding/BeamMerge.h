// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Beams/BeamVolume.h"
#include "nexrad/Calibration/RadarBiases.h"
#include "nexrad/Geometry/Beam.h"
#include "nexrad/Grid/GriddedVolume.h"
#include "nexrad/Gridding/BeamRows.h"
#include "nexrad/Polar/PolarVolume.h"
#include "nexrad/System/Progress.h"
#include "nexrad/System/RangeLoop.h"

#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace nexrad
{

struct BeamMergeOptions
{
  OverlapStrategy strategy = OverlapStrategy::Distance; ///< of REF and other moments that two
                                                        ///< radars see alike; VEL, SRV, DIV, SW and
                                                        ///< PHI take the nearest (Formulas W8),
                                                        ///< AZSHEAR the largest (V5)
  double overlapLength = 100'000.0;                     ///< m, L of Formulas W4; above 0
  Duration maximumGap = std::chrono::minutes(15); ///< a ray farther from the time does not count
  std::optional<double> beamWidth; ///< degrees; unless said, each radar's own (Formulas B4)
  BeamModel beam = BeamModel();    ///< path of the beams
  bool linearReflectivity = false; ///< interpolate Z in place of dBZ (Formulas G5)
  bool sharpen =
    true; ///< deconvolve the beam width in elevation (Formulas G9); of reflectivity in dBZ
  bool means = true; ///< take means where voxels are coarser than gates (Formulas G10)
  bool trend = true; ///< between tilts, follow the tilts beyond (Formulas G11) and layers (G12);
                     ///< else G8 alone. Reflectivity in dBZ
  bool fillColumns = false; ///< give values to voxels between and below those scanned (Formulas T7)
  bool ancillary = false;   ///< make GriddedVolume::ancillary
  bool codes = false; ///< make GriddedVolume::codes of moments whose codes have one byte whatever
                      ///< their voxels hold (MomentCode::Widest)
  RadarBiases biases; ///< dB that are taken off reflectivity of these radars before all else
                      ///< (Formulas Q6)
};

/// How radars that overlap are put together in a moment, where `wanted` is asked for: VEL, SRV and
/// SW, PHI and DIV take the nearest, AZSHEAR the largest value, the others what is wanted.
OverlapStrategy StrategyFor(MomentName moment, OverlapStrategy wanted);

/// Whether a merge with these options makes codes of a moment in place of values.
bool HasCodes(const BeamMergeOptions& options, MomentName moment);

/// Position and reach of a radar, from which follows whether it reaches a block.
struct SiteReach
{
  Position position;
  double reach = 0.0; ///< m, slant range at which its farthest gate ends, or more
};

/// Makes a volume ready for merges onto a grid: PrepareBeamVolume, and what the options ask for of
/// Q6 (biases), G9 (deconvolution in elevation), G10 (means over the grid's voxels) and G12
/// (layers). The composite, in which motion is looked for, has no bias taken off: it is the same
/// for processes that know a volume by its summary alone.
BeamVolume PrepareForGrid(
  const PolarVolume& volume, const GridSpecification& grid, const BeamMergeOptions& options);

/// Bytes that a BeamMerger keeps of the geometry of radars on a block of so many rows of a grid, or
/// more; 0 for all rows.
std::size_t GeometryBytes(
  const GridSpecification& grid, const std::vector<Position>& radars, int rows = 0);

/// What a merge at one time needs of its radars, whatever block of the grid is made.
struct BeamMergePlan
{
  BeamVolumes volumes; ///< with means for the grid
  Time time{};
  const MotionField* motion = nullptr; ///< as BeamMerger::Plan was given it; nullptr when it is 0
  std::vector<std::shared_ptr<const MergeSite>> sites;
  /// Of each column of the grid, x fastest, whether a radar gives an echo to any of its voxels: not
  /// 0. Merges note it; empty where nobody asks.
  std::vector<std::uint8_t> echoes;
};

/// The default method: merges volumes of any number of radars on a grid by the geometry of their
/// beams.
///
/// For each column of voxels and each radar: every tilt is sampled where it passes over the column
/// (G2, G7), in the observations before and after the time, with each ray's own time (A1, A5); the
/// voxels between the tilts, reflectivity in dBZ by G8, G11 and G12 and other moments linearly in
/// the elevation angle, none farther than half a beam width above the highest or below the lowest
/// (G3); then the radars together (W). What is not scanned, no echo and range folded stay apart
/// (G6).
///
/// With a motion, both observations are shifted along it to the time (A2a) and then blended;
/// without, they are blended without a shift.
///
/// An object serves one run: it keeps the geometry of each radar on the grid. The result does not
/// depend on the loop that runs the rows.
class BeamMerger
{
public:
  /// Throws Error for a grid without voxels.
  BeamMerger(const GridSpecification& grid, const BeamMergeOptions& options = {});

  /// The part of the grid that is made from now on: all of it unless said. What is made of a voxel
  /// does not depend on it. Throws Error as PartOf does.
  void SetBlock(const VoxelBlock& part);

  /// Of each radar, whether it reaches the block. Of one that does not, volumes without sweeps give
  /// the same result in Merge.
  std::vector<bool> FindReaching(const std::vector<SiteReach>& radars, const RangeLoop& loop = {});

  /// The merge at a time, of volumes from PrepareForGrid; means that a volume lacks for this grid
  /// are made here, and kept as long as the volume is held. Of each radar those about the time, in
  /// any order: the last one that ended before it, those in progress, the first one after it;
  /// others make no difference but cost time. All must hold the same moment and have a position.
  /// Without volumes no voxel is scanned. `motion`, of the grid, may be nullptr. Empty when
  /// `progress` asked to stop; it is called from this thread alone. `memory` is a volume that is no
  /// longer needed: its arrays become those of the result. A radar is named in the result also when
  /// none of its volumes has a sweep. Throws Error for a motion of another grid.
  std::optional<GriddedVolume> Merge(const BeamVolumes& volumes, Time time,
    const MotionField* motion, const RangeLoop& loop = {}, const Progress& progress = {},
    GriddedVolume memory = {});

  /// The same in two steps, for several blocks: Plan does what is common to all of them. `motion`
  /// must outlive the plan.
  BeamMergePlan Plan(
    const BeamVolumes& volumes, Time time, const MotionField* motion, const RangeLoop& loop = {});
  std::optional<GriddedVolume> Merge(BeamMergePlan& plan, const RangeLoop& loop = {},
    const Progress& progress = {}, GriddedVolume memory = {});

  /// A plan for the time and the motion of another one, of other volumes. Radars whose volumes are
  /// the same are taken from there.
  BeamMergePlan PlanAgain(
    const BeamMergePlan& before, const BeamVolumes& volumes, const RangeLoop& loop = {});
  /// The tiles of `size` columns along x and y, as far as the grid goes, that radars reach whose
  /// volumes differ between a plan and the one of which it was made.
  std::vector<VoxelBlock> FindTiles(
    const BeamMergePlan& before, const BeamMergePlan& after, int size) const;
  /// Marks the columns of a tile, x fastest, whose merge may differ: not 0. Several threads may ask
  /// at a time for different tiles, here and in MergeColumnsOf.
  std::vector<std::uint8_t> FindChanges(
    const BeamMergePlan& before, BeamMergePlan& after, const VoxelBlock& tile) const;
  /// The merge of the marked columns of a tile; its other voxels are not scanned.
  GriddedVolume MergeColumnsOf(
    BeamMergePlan& plan, const VoxelBlock& tile, const std::vector<std::uint8_t>& wanted) const;
  /// What the merge of a plan says of itself, without voxels.
  GriddedVolume Describe(const BeamMergePlan& plan) const;

  const GridSpecification& Grid() const { return grid; }
  const BeamMergeOptions& Options() const { return options; }

private:
  // A volume that was made ready for other voxels, with the means for these.
  struct Remade
  {
    std::weak_ptr<const BeamVolume> source; // as long as it is held elsewhere
    std::shared_ptr<const BeamVolume> volume;
  };

  BeamVolumes WithMeans(const BeamVolumes& volumes, const RangeLoop& loop);
  void FindGeometries(const std::vector<Position>& positions, const RangeLoop& loop);
  const SiteGeometry& GeometryOf(const Position& position) const;
  std::optional<MergeSite> MakeSite(int number, const std::vector<const BeamVolume*>& volumes,
    Time time, const MotionField* motion) const;
  void FindSites(BeamMergePlan& plan, const BeamMergePlan* before) const;
  void MakeRoom(const RowOptions& rows, GriddedVolume& volume) const;
  RowOptions RowsFor(BeamMergePlan& plan, MomentName moment, const VoxelBlock& part) const;

  const GridSpecification grid;
  const BeamMergeOptions options;
  VoxelBlock block;
  // Over the block, by latitude and longitude.
  std::map<std::array<double, 2>, std::shared_ptr<const SiteGeometry>> geometries;
  std::vector<Remade> remade;
};

} // namespace nexrad
