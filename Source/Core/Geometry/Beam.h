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
///
/// Both directions keep their precision near the antenna and near the horizon: Look(Locate(r, θ))
/// gives r back to better than 1 mm and θ to better than 1e-8° for r from 1 m to 500 km and θ from
/// −2° to 90° (straight up, groundDistance is 0 and stays it).
class BeamModel
{
public:
  /// `effectiveRadiusFactor` is k: 4/3 in the standard atmosphere; the NEXRAD system uses 1.21.
  /// Throws Error unless it is positive and finite.
  explicit BeamModel(double effectiveRadiusFactor = 4.0 / 3.0);

  /// B1. `slantRange` in m, `elevation` in degrees.
  BeamPoint Locate(double slantRange, double elevation) const;

  /// B2, the exact inverse of Locate. `groundDistance` and `height` (above the antenna) in m.
  BeamDirection Look(const BeamPoint& point) const;

  /// Height above the antenna, m, at which a beam of `elevation` degrees stands over a point of the
  /// ground `groundDistance` m away (B1 solved for the height). Infinity where it never gets there.
  double HeightOver(double groundDistance, double elevation) const;

  /// Ground distance, m, at which a beam of `elevation` degrees reaches a height above the antenna,
  /// m, at least 0 (B1 solved for the distance).
  double DistanceAt(double height, double elevation) const;

  /// a_e = k·a, m.
  double EffectiveRadius() const { return effectiveRadius; }

private:
  double effectiveRadius; // m
};

} // namespace nexrad
