// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Grid/GridSpecification.h"
#include "nexrad/Model/Moment.h"
#include "nexrad/Model/Time.h"

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
  NotScanned = 3 ///< no beam passed
};

/// The ancillary arrays of a merged volume, in the order of its values. They are made on demand:
/// each is empty, or has a value for every voxel. Voxels that no radar scanned have age, number and
/// weight 0, also where a column was filled.
struct VoxelCompanions
{
  static constexpr std::uint8_t NoSite = 255;

  std::vector<float> age; ///< s between the volume's time and the nearest ray that took part; 0
                          ///< where not scanned
  std::vector<std::uint8_t> radars;      ///< number of radars that scanned the voxel
  std::vector<float> weight;             ///< sum of their weights
  std::vector<std::uint8_t> nearestSite; ///< index in `sites` of the nearest of them, or NoSite
};

/// Calls `visit(name, values)` for each companion array of `companions`, which may be const.
template <class Companions, class Visit>
void ForEachCompanion(Companions& companions, const Visit& visit)
{
  visit("age", companions.age);
  visit("radars", companions.radars);
  visit("weight", companions.weight);
  visit("site", companions.nearestSite);
}

/// The name of a companion array in files and images: `REF_age` for "age".
inline std::string CompanionName(MomentName moment, const std::string& companion)
{
  return std::string(ToString(moment)) + "_" + companion;
}

/// One moment of several radars on one grid at one time.
struct GriddedVolume
{
  GridSpecification grid;
  Time time{};
  MomentName moment = MomentName::REF;
  std::string method;             ///< "thesis" or "beam"
  std::vector<std::string> sites; ///< names of the radars that took part
  bool synthetic = false;         ///< made from simulated files; pictures must say so
  float fill = -33.0F;            ///< value where the state is NoEcho or NotScanned
  std::vector<float> values;      ///< x fastest, then y, then z upward
  std::vector<VoxelState> states;
  VoxelCompanions companions; ///< of the method "beam", when asked for
};

} // namespace nexrad
