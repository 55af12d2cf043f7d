// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Grid/MakeGrid.h"
#include "nexrad/Gridding/BeamMerge.h"
#include "nexrad/Model/Moment.h"
#include "nexrad/Moments/MomentMaker.h"
#include "nexrad/Motion/MotionField.h"
#include "nexrad/Series/Catalogue.h"
#include "nexrad/Series/ScannedFile.h"
#include "nexrad/Series/VolumeSelection.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace nexrad
{

/// How rays become voxels.
enum class MergeMethod
{
  Thesis, ///< Formulas T1–T7
  Beam    ///< Formulas G, W and A: BeamMerger
};

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

/// Time between two volumes when nobody says otherwise.
constexpr Duration DefaultStep = std::chrono::minutes(5);

/// The memory that a run may take.
struct MemoryLimit
{
  std::size_t bytes = 0; ///< 0: not limited
  std::string option;    ///< that set it, as "--memory", for messages; empty: the machine has no
                         ///< more
};

/// What a user asks of merged volumes.
struct MergeOptions : MergeRules
{
  GridRequest grid;             ///< without a range: SeriesScan::Range
  std::optional<Duration> step; ///< empty: DefaultStep; of one volume alone, its middle
  std::optional<Time> begin;    ///< in place of the first step at or after the first ray
  std::optional<Time> end;      ///< in place of the last step at or before the last ray; inclusive
  std::optional<Time> time;     ///< this time alone, between the first and the last ray
  bool atLeastOne = false; ///< where no step lies between the first and the last ray: their middle
  std::vector<MomentName> moments = {MomentName::REF}; ///< one at least, each merged of files that
                                                       ///< are decoded once
  bool measureBiases = false; ///< take the biases that the comparison of the radars finds (Formulas
                              ///< Q6) off reflectivity, in place of BeamMergeOptions::biases: with
                              ///< several radars, all files are decoded before the first merge
  bool compareRadars = false; ///< compare them also where nothing of it is taken off
  std::string siteName;       ///< in place of the names in the files; empty: as the files say
  std::size_t memory = std::size_t(1) << 30; ///< bytes for rays that are kept for later steps; 0
                                             ///< keeps none
  MemoryLimit memoryLimit; ///< of all that the run takes: a grid that needs more is refused before
                           ///< anything is decoded (RequireMemory)
};

/// What options ask of a scan. Throws Error for a moment that the method does not know, and for one
/// that is named twice.
SeriesOptions SeriesOptionsOf(const MergeOptions& options);

/// The grid that options name, about radars whose own domain has a radius of `range` m.
GridSpecification GridOf(
  const MergeOptions& options, const std::vector<Position>& positions, double range);

/// The time steps between the first and the last ray of `volumes` volumes, or those that the
/// options name. Throws Error when there is none.
std::vector<Time> TimeStepsOf(
  const MergeOptions& options, Time firstRay, Time lastRay, std::size_t volumes);

/// A pause of days between volumes, of which the options do not say at which side of it to begin or
/// to end.
std::optional<TimeSpan> FindPause(
  const MergeOptions& options, const std::vector<TimeSpan>& volumes);

/// The time steps of all volumes of a scan. Throws Error also for a pause of days, and for a time
/// alone at which nothing was scanned.
std::vector<Time> TimeStepsOf(const MergeOptions& options, const SeriesScan& scan);

} // namespace nexrad
