// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Beams/VolumeSummary.h"
#include "nexrad/Calibration/LowEcho.h"
#include "nexrad/Grid/MakeGrid.h"
#include "nexrad/Model/Moment.h"
#include "nexrad/Model/Site.h"
#include "nexrad/Quality/EchoClass.h"
#include "nexrad/Series/InputFiles.h"
#include "nexrad/Series/VolumeSelection.h"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace nexrad
{

/// One volume among the inputs: where it stands and when it was scanned. Its data are elsewhere.
struct SeriesVolume
{
  std::filesystem::path file; ///< a Level II file or a chunk folder
  std::size_t cycle = 0;      ///< which of the cycles in the file (SplitCycles), from 0
  Time start{};               ///< first ray
  Time end{};                 ///< last ray
  bool begun = false;         ///< its first ray begins a volume
  Duration left{};            ///< VolumeCuts::left
  std::size_t rays = 0;
  double reach =
    0.0; ///< m, slant range to which two of its tilts of the moment see, or its only one
  bool synthetic = false;                       ///< made by the simulator
  std::shared_ptr<const VolumeSummary> summary; ///< when it was asked for
  std::shared_ptr<const LowEcho> lowEcho;       ///< of reflectivity, when it was asked for
  std::vector<MomentName> moments;              ///< all that some ray has
  std::vector<MomentName> lacking;  ///< of the moments that were asked for, those that no ray has
  std::optional<ReasonCounts> echo; ///< gates of reflectivity by what quality control found in
                                    ///< them, once it was made; empty where quality control is off

  bool Has(MomentName moment) const;
};

/// Chooses among volumes by their starts, which ascend, and ends.
using VolumeChoice = std::function<std::vector<std::size_t>(
  const std::vector<Time>& starts, const std::vector<Time>& ends)>;

/// Of volumes by start time, those that a choice takes among the ones with a moment.
std::vector<const SeriesVolume*> ChooseWith(
  MomentName moment, const std::vector<SeriesVolume>& volumes, const VolumeChoice& choose);

/// All volumes of one radar.
struct SiteSeries
{
  Site site;
  std::vector<SeriesVolume> volumes; ///< by start time, no two alike; never empty

  std::vector<Time> Starts() const;
  std::vector<Time> Ends() const;
};

/// Radius of the domain that shows what one radar sees, m: of a terminal radar the volume's reach,
/// else DefaultRange.
double RangeOf(const Site& site, const SeriesVolume& volume);

/// What is in a list of radar files of any number of sites.
struct SeriesScan
{
  std::vector<SiteSeries> sites;      ///< by name
  std::vector<InputProblem> problems; ///< in the order of the inputs
  std::vector<std::string> notes;     ///< of the files, as in ScannedFile, in their order

  /// Times of the first and of the last ray of all volumes; empty without volumes.
  std::optional<Time> First() const;
  std::optional<Time> Last() const;
  /// From the first to the last ray of each volume.
  std::vector<TimeSpan> Spans() const;
  /// RangeOf a radar that is alone, and its first volume; of several DefaultRange. m
  double Range() const;
  /// Positions of the sites that have one.
  std::vector<Position> Positions() const;
};

} // namespace nexrad
