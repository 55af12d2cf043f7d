// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Beams/BeamVolume.h"
#include "nexrad/Calibration/LowEcho.h"
#include "nexrad/Grid/MakeGrid.h"
#include "nexrad/Model/Moment.h"
#include "nexrad/Model/Site.h"
#include "nexrad/Quality/EchoClass.h"
#include "nexrad/Series/InputFiles.h"
#include "nexrad/Series/VolumeSelection.h"

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace nexrad
{

/// One volume among the inputs: where it stands and when it was scanned. Its data are elsewhere.
struct SeriesVolume
{
  std::size_t input = 0;      ///< place of the file among the inputs, once it is in a catalogue
  std::filesystem::path file; ///< a Level II file or a chunk folder
  std::string origin;         ///< OriginOf this file, or its name where it may still change
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
  std::vector<MomentName> moments;  ///< all that some ray has; empty where that is not known
  std::optional<ReasonCounts> echo; ///< gates of reflectivity by what quality control found in
                                    ///< them, once it was made; empty where quality control is off
  std::optional<double> endsAt;     ///< PolarVolume::endsAt, once a moment was made

  /// Whether some ray has, or may have, a moment.
  bool Has(MomentName moment) const;
};

/// The order of a site's volumes: by their first rays; of two that share it the one that stays,
/// with more rays, first, and of two such that of the first input.
bool IsBefore(const SeriesVolume& a, const SeriesVolume& b);

/// All volumes of one radar.
struct SiteSeries
{
  Site site;
  std::vector<SeriesVolume> volumes; ///< by start, no two alike; never empty in a catalogue

  /// Adds a volume. Of two with the same first ray the one with more rays stays; of two such, that
  /// of the input that was named first.
  void Put(const SeriesVolume& volume);
  /// Of the volumes with a moment, those that a rule takes at a time.
  std::vector<const SeriesVolume*> ChosenAt(
    Time time, const VolumeRule& rule, MomentName moment) const;
};

/// A volume that takes part in the merge of a moment.
struct ChosenVolume
{
  MomentName moment{};
  std::size_t site = 0;                 ///< place of the radar in the catalogue
  const SeriesVolume* volume = nullptr; ///< in the catalogue, as long as that stays as it is
};

/// Radius of the domain that shows what one radar sees, m: of a terminal radar the volume's reach,
/// else DefaultRange.
double RangeOf(const Site& site, const SeriesVolume& volume);

/// The volumes that are known of any number of radars, and which of them take part at a time.
struct Catalogue
{
  std::vector<SiteSeries> sites; ///< by KeyOf

  /// The radar of that key; a new one stands where `site` does, and has no volume yet.
  SiteSeries& Of(const Site& site);

  /// The volumes that take part at a time: by moment, radar and start. Of each moment these are
  /// chosen among the volumes that have it.
  std::vector<ChosenVolume> ChosenAt(
    Time time, const VolumeRule& rule, const std::vector<MomentName>& moments) const;
  /// What the merge at a time is made of, as text: a line for each volume that ChosenAt gives, with
  /// all that tells it from others. A merge whose text stays the same stays as it is.
  std::string MadeOf(
    Time time, const VolumeRule& rule, const std::vector<MomentName>& moments) const;

  /// Times of the first and of the last ray of all volumes; empty without volumes.
  std::optional<Time> First() const;
  std::optional<Time> Last() const;
  /// From the first to the last ray of each volume, in the order of their first rays.
  std::vector<TimeSpan> Spans() const;
  /// RangeOf a radar that is alone, and its first volume; of several DefaultRange. m
  double Range() const;
  /// Positions of the sites that have one.
  std::vector<Position> Positions() const;
};

/// What is in a list of radar files of any number of sites.
struct SeriesScan : Catalogue
{
  std::vector<InputProblem> problems; ///< in the order of the inputs
  std::vector<std::string> notes;     ///< of the files, as in ScannedFile, in their order
};

} // namespace nexrad
