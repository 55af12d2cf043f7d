// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace nexrad
{

/// Where a point of the beam is: its height above the antenna and its distance along the ground, m.
struct BeamPoint
{
  double height = 0.0;
  double groundDistance = 0.0;
};

/// How the antenna sees a point: slant range in m, elevation angle in degrees.
struct BeamDirection
{
  double slantRange = 0.0;
  double elevation = 0.0;
};

/// The path of the beam over an earth of k times its radius, which makes refracted rays straight
/// (Formulas B1, B2; Doviak and Zrnić 1993). 6 371 000 m is the earth's radius.
class BeamModel
{
public:
  /// `effectiveRadiusFactor` is k: 4/3 in the standard atmosphere; the NEXRAD system uses 1.21.
  explicit BeamModel(double effectiveRadiusFactor = 4.0 / 3.0);

  /// B1. `slantRange` in m, `elevation` in degrees.
  BeamPoint Locate(double slantRange, double elevation) const;

  /// B2, the exact inverse of Locate. `groundDistance` and `height` (above the antenna) in m.
  BeamDirection Look(const BeamPoint& point) const;

private:
  double effectiveRadius; // m
};

} // namespace nexrad
