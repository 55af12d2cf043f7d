// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Grid/GriddedVolume.h"
#include "nexrad/Motion/MotionEstimate.h"

#include <array>
#include <cstddef>

namespace nexrad
{

/// How far a rebuilt volume is from the observed one, over the voxels that both tell something
/// about (echo or no echo). No echo, and echo below 0 dBZ, counts as 0 dBZ.
struct RebuildScore
{
  static constexpr std::array<float, 3> Thresholds = {20.0F, 35.0F, 50.0F}; ///< dBZ

  std::size_t voxels = 0;                 ///< voxels that count
  std::size_t compared = 0;               ///< of them, those where either volume is above 0 dBZ
  double squares = 0.0;                   ///< dBZ², sum of the squared differences
  std::array<std::size_t, 3> hits = {};   ///< both at least the threshold
  std::array<std::size_t, 3> misses = {}; ///< the observed volume alone
  std::array<std::size_t, 3> falseAlarms = {}; ///< the rebuilt volume alone

  /// dBZ, root mean square difference over `compared`; 0 for none.
  double Rmse() const;
  /// Critical success index at a threshold (0…2): hits / (hits + misses + false alarms), 0…1; 1
  /// when neither volume reaches it.
  double SuccessIndex(std::size_t threshold) const;
  /// Adds the voxels of another score.
  RebuildScore& operator+=(const RebuildScore& other);
};

/// Throws Error when the volumes differ in size.
RebuildScore ScoreRebuilt(const GriddedVolume& rebuilt, const GriddedVolume& observed);

/// The worth of ways to interpolate in time (Formulas A4).
struct LeaveOneOutScore
{
  RebuildScore linear;      ///< A1
  RebuildScore alongMotion; ///< A2 with the motion of A3
};

/// Rebuilds the middle one of three volumes from the other two and compares. Throws Error as
/// EstimateMotion and TimeInterpolation do.
LeaveOneOutScore LeaveOneOut(const GriddedVolume& first, const GriddedVolume& middle,
  const GriddedVolume& last, const MotionOptions& options = {});

} // namespace nexrad
