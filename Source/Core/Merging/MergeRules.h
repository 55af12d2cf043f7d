// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Gridding/BeamMerge.h"
#include "nexrad/Model/Moment.h"
#include "nexrad/Moments/MomentOptions.h"
#include "nexrad/Motion/MotionField.h"
#include "nexrad/Series/VolumeSelection.h"

#include <optional>
#include <string_view>

namespace nexrad
{

/// How rays become voxels.
enum class MergeMethod
{
  Thesis, ///< Formulas T1–T7
  Beam    ///< Formulas G, W and A: BeamMerger
};

/// "thesis", "beam".
const char* ToString(MergeMethod method);
/// Empty when the text names no method.
std::optional<MergeMethod> ParseMergeMethod(std::string_view text);

/// How Beam interpolates between two observations of a radar.
enum class TimeInterpolationMethod
{
  Linear,     ///< without a shift (Formulas A1)
  AlongMotion ///< each shifted along the motion of the echo (A2a), where that is known
};

/// How volumes are merged, whatever the grid and the time; as MomentOptions, how the moments of a
/// volume are made before.
struct MergeRules : MomentOptions
{
  /// Quality control takes out what QualityLevel::Standard does.
  MergeRules() { quality.level = QualityLevel::Standard; }

  MergeMethod method = MergeMethod::Beam;
  Duration maximumGap = std::chrono::minutes(15); ///< what was seen farther from the time does not
                                                  ///< count: for Thesis a volume, by its start; for
                                                  ///< Beam a ray
  BeamMergeOptions beam;                          ///< of Beam; its largest gap is not used
  TimeInterpolationMethod interpolation = TimeInterpolationMethod::AlongMotion; ///< of Beam
  std::optional<Velocity> motion; ///< for AlongMotion, in place of the one found from reflectivity,
                                  ///< at most FastestEcho; without it other moments are
                                  ///< interpolated linearly
};

/// How the moments are made for the method of the rules: Thesis takes the gates as they are, but
/// for despeckling.
MomentOptions MomentOptionsOf(const MergeRules& rules);

/// Which volumes the method takes: Thesis by their nominal times, Beam those about the time.
VolumeRule VolumeRuleOf(const MergeRules& rules);

/// Throws Error when the method does not know the moment: Thesis knows REF alone.
void RequireMoment(MergeMethod method, MomentName moment);

} // namespace nexrad
