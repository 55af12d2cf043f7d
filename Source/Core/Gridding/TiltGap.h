// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Gridding/BeamSampling.h"
#include "Gridding/SiteLevels.h"
#include "Gridding/TiltEdges.h"

#include <cstddef>
#include <vector>

namespace nexrad
{

/// What one radar has on its tilts in the direction of a column, at any distance.
struct TiltLookup
{
  const std::vector<BeamTilt>* tilts = nullptr;
  const SamplingContext* context = nullptr;
  ColumnDirection column;
  const ColumnMotion* motion = nullptr; ///< nullptr: linear in time

  /// SampleTilt at another distance (ColumnDirection::halfTangent).
  TiltSample At(std::size_t tilt, float halfTangent) const;
};

/// The voxels of a column between two neighbouring tilts of one radar that both measured:
/// reflectivity in dBZ, in which no echo counts as 0 dBZ.
struct TiltGap
{
  const std::vector<TiltEdges>* edges = nullptr; ///< of all tilts of the radar
  const TiltSample* samples = nullptr;           ///< over the column, of all tilts
  std::size_t lower = 0;                         ///< the lower of the two tilts
  int from = 0;                                  ///< first level of the gap
  int to = 0;                                    ///< first level above it
};

/// Interpolates in elevation over the column: the four-point cubic (Formulas G11), between an echo
/// and none about the line of G8. `shares` are the parts of the way in angle from the lower tilt to
/// the upper one. Both arrays are indexed by level; levels from `from` to `to` − 1 are set.
void InterpolateUpwards(const TiltGap& gap, const float* shares, float* values);

/// Moves the values that InterpolateUpwards made towards those interpolated at constant height
/// (Formulas G12): `share`, 0…1, is how much the echo lies in layers. `halfTangent` is the column's
/// (ColumnDirection). Levels at which a tilt measured nothing at that height stay.
void BlendLayers(const TiltGap& gap, float share, const SiteLevels& levels,
  const TiltLookup& lookup, float halfTangent, float* values);

} // namespace nexrad
