// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Grid/GriddedVolume.h"
#include "nexrad/Motion/MotionField.h"

namespace nexrad
{

/// A volume of reflectivity at a time between two others, linear (Formulas A1) or along the motion
/// of the echo (A2). The volumes and the motion are not owned and must outlive the object.
///
/// States: two echoes blend; an echo and no echo blend as if no echo were 0 dBZ, and 0 dBZ or less
/// is then no echo. A voxel that is range folded or not scanned at one time takes the other time's
/// value unchanged; at both times, it is range folded where either is, else not scanned. Along the
/// motion, the four voxels about each displaced place are blended by the same rules. Where less
/// than half of their weight is echo or no echo, or the place lies outside the grid, the voxel is
/// interpolated linearly.
class TimeInterpolation
{
public:
  /// Linear. Throws Error when the volumes cannot be interpolated between (RequirePair) or `time`
  /// lies outside their times.
  TimeInterpolation(const GriddedVolume& before, const GriddedVolume& after, Time time);
  /// Along the motion; `motion` may be given (MotionField::Constant) or found (EstimateMotion).
  /// Throws as the other, and for a motion of another grid.
  TimeInterpolation(
    const GriddedVolume& before, const GriddedVolume& after, Time time, const MotionField& motion);

  /// The volume at that time, its voxels still to be filled.
  GriddedVolume MakeVolume() const;

  /// Fills the rows [begin, end) at all heights of a volume from MakeVolume. Ranges can be filled
  /// side by side; the result does not depend on how the rows are divided.
  void FillRows(int begin, int end, GriddedVolume& volume) const;

private:
  const GriddedVolume& before;
  const GriddedVolume& after;
  const Time time;
  const MotionField* motion; // nullptr: linear
  const float share;         // of `after`
};

/// The whole volume at once.
GriddedVolume InterpolateLinear(const GriddedVolume& before, const GriddedVolume& after, Time time);
GriddedVolume InterpolateAlongMotion(
  const GriddedVolume& before, const GriddedVolume& after, Time time, const MotionField& motion);

} // namespace nexrad
