// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

namespace nexrad
{

/// A tilt as the vertical interpolation needs it: tangents of elevations, which are linear in
/// h/(a_e + h) over a column (Formulas G7). The last seven are of the gap to the next tilt.
struct TiltEdges
{
  float elevation = 0.0F;  ///< degrees, of the tilt
  float tangent = 0.0F;    ///< of the tilt
  float perDegree = 0.0F;  ///< how much the tangent grows with the elevation there
  float lower = 0.0F;      ///< half a beam width below the tilt
  float upper = 0.0F;      ///< half a beam width above it
  float middle = 0.0F;     ///< midway in angle to the next tilt
  float bend = 0.0F;       ///< turns a share of the tangent's way into a share of the angle's:
                           ///< share + bend·share·(1 − share)
  float endAbove = 0.0F;   ///< where an echo of this tilt ends below a next one without (G8)
  float endBelow = 0.0F;   ///< where an echo of the next tilt ends above this one without
  float trendBelow = 0.0F; ///< how much of the change from the tilt below counts in the gap (G11)
  float trendAbove = 0.0F; ///< likewise of the change beyond the next tilt
  float endShare = 1.0F;   ///< part of the way between the tilts that either end is from its echo
};

/// The edges of tilts at elevations that ascend. All in degrees.
std::vector<TiltEdges> FindEdges(const std::vector<float>& elevations, double beamWidth);

/// Reflectivity over one place on two neighbouring tilts and the tilts beyond them, dBZ, in which
/// no echo is 0 dBZ.
struct TiltGapValues
{
  float below = std::numeric_limits<float>::quiet_NaN(); ///< of the tilt below the two;
                                                         ///< not-a-number where it measured nothing
  float lower = 0.0F;
  float upper = 0.0F;
  float above = std::numeric_limits<float>::quiet_NaN(); ///< of the tilt above the two, likewise
  bool lowerEcho = false;
  bool upperEcho = false;
};

/// Interpolates in elevation (Formulas G11): the four-point cubic, between an echo and none about
/// the line of G8. `edges` are those of the lower tilt; `share`, 0…1, is the part of the way in
/// angle from the lower tilt to the upper one.
class TiltInterpolation
{
public:
  TiltInterpolation(const TiltGapValues& values, const TiltEdges& edges);

  float At(float share) const { return from + share * perShare + curve * share * (1.0F - share); }

private:
  float from;
  float perShare;
  float curve; // four times what the tilts beyond add in the middle
};

} // namespace nexrad
