// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Polar/PolarVolume.h"
#include "nexrad/Quality/EchoClass.h"
#include "nexrad/Velocity/VelocityVolume.h"
#include "nexrad/Velocity/WindProfile.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace nexrad
{

/// How the moments of a volume are made before they are merged.
struct MomentOptions
{
  QualityOptions quality; ///< its level is of reflectivity alone
  bool dealias = true;    ///< unfold the velocities of VEL (Formulas V1 to V4). The derived moments
                          ///< are made of unfolded velocities whatever this says
  /// The motion of the storm that SRV is relative to, m/s; empty: EstimateStormMotion of each
  /// volume.
  std::optional<Wind> stormMotion;

  bool operator==(const MomentOptions& other) const;
};

/// The motion of storms, m/s, as far as one volume of dealiased velocities tells it: the mean of
/// the wind up to 6 km above the antenna, of the volume's wind profile (FitWindProfile, up to 60 km
/// from the radar; at heights at which that has no wind, up to 120 km), every 100 m of height that
/// has a wind counting alike. Where echo is shallow that is the mean over the depth of the echo.
/// Empty where less than 2 km of the heights have a wind.
std::optional<Wind> EstimateStormMotion(const VelocityVolume& volume);

/// Makes the moments of one volume for merging: the one place in which polar data of a moment,
/// measured or derived, come about.
///
/// - VEL: dealiased (Formulas V1 to V4), by what the volume itself tells; a gate whose fold nothing
///   decides becomes NotSampled. A sweep in which no fold changes keeps the codes of the file.
///   Without MomentOptions::dealias: as MakePolarVolume makes it.
/// - SRV: the dealiased velocity relative to the motion of the storm (P5). Without a motion that is
///   given or can be estimated all its gates are NotSampled, and Note says so.
/// - AZSHEAR, DIV: shear along the azimuth and divergence along the ray of dealiased velocities
///   (V5); a gate with a velocity but without enough neighbours becomes NotSampled.
/// - KDP: MakePhaseSlopes (V6).
/// - REF: with the gates Filtered that QualityOptions::level takes out (TakeOut, Formulas Q1 to
/// Q5).
/// - other moments: as MakePolarVolume makes them. Quality control takes nothing out of them.
///
/// QualityOptions::neighbours is applied to each of them last. Velocities are dealiased once for
/// all moments that need them.
class MomentMaker
{
public:
  /// The volume must outlive this object.
  MomentMaker(const RadarVolume& volume, const MomentOptions& options);
  MomentMaker(MeasuredVolume measured, const MomentOptions& options);

  PolarVolume Make(MomentName moment);

  /// One line on why a moment that was made has no values; empty when there is nothing to say.
  const std::string& Note() const { return note; }

  /// What quality control found in the reflectivity that was made, gates by reason; empty where it
  /// is off, or no reflectivity was made.
  const std::optional<ReasonCounts>& Echo() const { return echo; }

private:
  struct Velocities
  {
    PolarVolume folded;
    VelocityVolume unfolded;
  };

  const Velocities& Unfolded();
  PolarVolume MakeRaw(MomentName moment);
  PolarVolume MakeReflectivity();
  PolarVolume MakeStormRelative();
  PolarVolume MakeDerived(
    MomentName moment, const std::function<std::vector<float>(const VelocitySweep&)>& valuesOf);

  MeasuredVolume measured;
  MomentOptions options;
  std::optional<Velocities> velocities;
  std::string note;
  std::optional<ReasonCounts> echo;
};

} // namespace nexrad
