// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Quality/EchoClass.h"
#include "nexrad/Velocity/WindProfile.h"

#include <optional>

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
  bool operator!=(const MomentOptions& other) const { return !(*this == other); }
};

} // namespace nexrad
