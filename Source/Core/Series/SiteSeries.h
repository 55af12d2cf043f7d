// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Beams/VolumeDigest.h"
#include "nexrad/Grid/MakeGrid.h"
#include "nexrad/Level2/Level2File.h"
#include "nexrad/Model/RadarVolume.h"
#include "nexrad/Quality/Despeckling.h"
#include "nexrad/Series/InputFiles.h"
#include "nexrad/Series/VolumeSelection.h"
#include "nexrad/System/Processes.h"
#include "nexrad/System/Progress.h"

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
  std::size_t rays = 0;
  double reach = 0.0; ///< m, slant range to which half of its sweeps of the moment see, or farther
  bool synthetic = false;                     ///< made by the simulator
  std::shared_ptr<const VolumeDigest> digest; ///< when it was asked for
};

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

/// What the files that one of several processes scans have in common.
enum class ScanOrder
{
  ByTime,      ///< neighbouring times
  ByLongitude, ///< neighbouring sites from west to east, and their times
  ByLatitude   ///< neighbouring sites from south to north, and their times
};

struct SeriesOptions
{
  Level2Options level2;
  std::optional<MomentName> moment; ///< a volume without it is left out
  QualityOptions quality;           ///< of the volumes that visitors and digests are made of
  bool requirePosition = false;     ///< a volume of a site without a position is left out
  bool digests = false; ///< make the digests of the volumes, of `moment`, which must be set
  Processes processes;  ///< that scan the inputs together
  ScanOrder order = ScanOrder::ByTime; ///< of the parts that they scan
};

/// Called for each volume while its data are in memory, from several threads at once. The last is
/// the moment of the options after quality control, nullptr without a moment.
using VolumeVisitor = std::function<void(
  const SeriesVolume&, const RadarVolume&, const std::shared_ptr<const PolarVolume>&)>;

/// Decodes each input once, a few at a time on as many threads, and says what volumes there are. A
/// file belongs to the site that stands in it, whatever its name. Of two volumes of one site with
/// the same first ray the one with more rays stays. Damage, and what was left out, is in
/// `problems`; `progress` is called from this thread alone. Empty when `progress` asked to stop.
/// Throws Error as FindInputFiles does.
///
/// Several processes scan a part each, of neighbouring times or sites, so that a process finds most
/// volumes of its part of the day, or of the country, among those that it visited. All get the same
/// result: also when one of them fails or is asked to stop.
std::optional<SeriesScan> ScanInputs(const std::vector<std::filesystem::path>& inputs,
  const SeriesOptions& options = {}, const VolumeVisitor& visitor = {},
  const Progress& progress = {});

} // namespace nexrad
