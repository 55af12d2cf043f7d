// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Grid/GridSpecification.h"
#include "nexrad/Model/Moment.h"
#include "nexrad/Model/Site.h"
#include "nexrad/Model/Time.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace nexrad
{

/// What a voxel holds. The numbers are those of the `<NAME>_state` arrays.
enum class VoxelState : std::uint8_t
{
  Echo = 0,
  NoEcho = 1, ///< scanned, and nothing there
  RangeFolded = 2,
  NotScanned = 3, ///< no beam passed
  Filtered = 4    ///< quality control took the echo out, and no other radar saw the place
                  ///< (Formulas Q5)
};

constexpr std::size_t VoxelStateCount = 5;

/// The state that a number of a `<NAME>_state` array stands for; NotScanned for one that has no
/// meaning.
constexpr VoxelState ToVoxelState(std::uint8_t number)
{
  return number < VoxelStateCount ? static_cast<VoxelState>(number) : VoxelState::NotScanned;
}

/// Whether a place was measured: echo or no echo.
constexpr bool IsMeasured(VoxelState state)
{
  return state == VoxelState::Echo || state == VoxelState::NoEcho;
}

/// Of two states of places that were not measured the one that says more: range folded, then
/// filtered, then not scanned.
constexpr VoxelState MoreKnown(VoxelState first, VoxelState second)
{
  return first == VoxelState::RangeFolded || second == VoxelState::RangeFolded
           ? VoxelState::RangeFolded
         : first == VoxelState::Filtered ? first
                                         : second;
}

/// The ancillary arrays of a merged volume, in the order of its values. They are made on demand:
/// each is empty, or has a value for every voxel. Voxels that no radar scanned have age, number and
/// weight 0, also where a column was filled.
struct AncillaryArrays
{
  static constexpr std::uint8_t NoSite = 255;

  std::vector<float> age; ///< s between the volume's time and the nearest ray that took part; 0
                          ///< where not scanned
  std::vector<std::uint8_t> radars;      ///< number of radars that scanned the voxel
  std::vector<float> weight;             ///< sum of their weights
  std::vector<std::uint8_t> nearestSite; ///< index in `sites` of the nearest of them, or NoSite
};

/// Calls `visit(name, values)` for each ancillary array of `ancillary`, which may be const.
template <class Arrays, class Visit>
void ForEachAncillaryArray(Arrays& ancillary, const Visit& visit)
{
  visit("age", ancillary.age);
  visit("radars", ancillary.radars);
  visit("weight", ancillary.weight);
  visit("site", ancillary.nearestSite);
}

/// The name of an ancillary array in files and images: `REF_age` for "age".
inline std::string AncillaryArrayName(MomentName moment, const std::string& ancillary)
{
  return std::string(ToString(moment)) + "_" + ancillary;
}

/// Voxels one after the other of one state.
struct StateRun
{
  std::size_t first = 0; ///< number of the first voxel
  std::size_t count = 0;
  VoxelState state = VoxelState::NotScanned;
};

/// What a merged volume says of itself.
struct GriddedVolumeDescription
{
  GridSpecification grid;
  Time time{};
  MomentName moment = MomentName::REF;
  std::string method;                  ///< "thesis" or "beam"
  std::vector<std::string> sites;      ///< names of the radars that took part
  std::vector<Position> sitePositions; ///< of `sites`, in their order; empty when not known
  /// Of one of several radars alone, on the grid of all. What is made of it (images, NetCDF files)
  /// has the radar's view of the grid (RadarView).
  bool ofOneRadar = false;
  bool sharpened = false; ///< REF was deconvolved in elevation (Formulas G9); maps must say so
  bool synthetic = false; ///< made from simulated files; pictures must say so
  /// Of the gates of reflectivity that were merged, the part that quality control calls biological,
  /// 0…1; 0 where it is off.
  float biologicalShare = 0.0F;
  std::vector<std::string> notes; ///< what pictures must say of the radars' volumes, a phrase each:
                                  ///< "KTLX: volume ends at 6.4°, cut off"
  float fill = -33.0F;            ///< value where the state is not Echo
};

/// A moment of several radars on one grid at one time, and further moments where they were asked
/// for.
struct GriddedVolume : GriddedVolumeDescription
{
  std::vector<float> values; ///< x fastest, then y, then z upward
  /// In place of values and states, of a merge that was asked for them (BeamMergeOptions::codes):
  /// those of MomentCode::Widest, of one byte. Such a volume serves to be written, and nothing
  /// else.
  std::vector<std::uint8_t> codes;
  std::vector<StateRun> statesBesideCodes; ///< voxels that are range folded or filtered, ascending
  std::vector<VoxelState> states;
  AncillaryArrays ancillary; ///< of the method "beam", when asked for

  /// Other moments on the same grid at the same time, with the same sites; none of them has further
  /// ones of its own.
  std::vector<GriddedVolume> further;
};

/// Columns of a grid with all its levels, of which some become others.
struct ChangedTile
{
  VoxelBlock block; ///< of the grid
  /// Of the block, with all moments and ancillary arrays. What voxels outside the cells that change
  /// hold has no meaning, but must be possible.
  GriddedVolume volume;
  /// Of each cell of some columns along x and y, x fastest: not 0 where its voxels become others.
  /// At the upper faces of the grid cells have fewer columns.
  std::vector<std::uint8_t> changed;
};

/// What a volume says of itself, without its voxels and its further moments.
GriddedVolume WithoutVoxels(const GriddedVolume& volume);

/// Moments that were merged at one time on one grid, at least one, as one volume: the first, with
/// the others as its further ones. Each names the radars that took part in any of them.
GriddedVolume JoinMoments(std::vector<GriddedVolume> moments);

/// The moments of a volume, each as a volume of its own: the opposite of JoinMoments.
std::vector<GriddedVolume> SplitMoments(GriddedVolume volume);

} // namespace nexrad
