// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Volumes/GridTask.h"
#include "Volumes/VolumeFiles.h"
#include "nexrad/Calibration/RadarBiases.h"
#include "nexrad/Merging/MergeOptions.h"
#include "nexrad/Quality/EchoClass.h"
#include "nexrad/System/Processes.h"
#include "nexrad/System/Progress.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace nexrad::application
{

/// Radar files to be merged, and where to.
struct GridJob
{
  std::vector<std::filesystem::path> inputs;
  std::filesystem::path folder; ///< made when it does not exist
  VolumeFiles written;          ///< how the volumes are stored
  /// A volume of each radar alone, on the grid of all, in place of the merged one.
  bool perRadar = false;
  bool oneFile = false; ///< of VolumeFormat::NetCDF: all times in one file, volumes.nc
  MergeOptions options;
  /// All that decides what the volumes contain, beside the content of the inputs, as text. A run
  /// that was interrupted is continued by one with the same text. Empty: never.
  std::string recipe;
  std::optional<GridTask> task; ///< this part of the run alone; of volumes in bricks
};

/// What WriteVolumes made.
struct GridReport
{
  std::vector<std::filesystem::path> indices; ///< of the series: one, or one of each radar; where
                                              ///< all times are in one file, that; of a task, but
                                              ///< of the last, none
  std::vector<std::filesystem::path> files;   ///< one for each time, or one
  std::uintmax_t bytes = 0;                   ///< of the files together
  std::vector<std::string> problems;          ///< inputs that were damaged or left out, a line each
  std::vector<std::string> notes;   ///< what is left out of inputs in which nothing is wrong
  BiasReport comparison;            ///< of the radars, where there are several
  RadarBiases takenOff;             ///< biases that were taken off reflectivity
  std::optional<ReasonCounts> echo; ///< gates of reflectivity by what quality control found
                                    ///< in the volumes that were merged; empty without it
};

/// Writes one volume for each time step, named by its time in UTC as 20060312T180500Z.nxv, and an
/// index of them, volumes.nxv.series (or .nc, volumes.nc.series), in the form that ParaView uses
/// for series; or, of NetCDF, one file of all times in place of both. Each radar has a series of
/// its own where they are not merged. Each file appears whole or not at all; the index comes last.
/// Volumes and index that were there before are replaced only when all new ones are there, so that
/// a run which fails changes none of them. A run that was interrupted, by an error or by the end of
/// the process, is continued by the next one with the same recipe (UnfinishedRun): it makes the
/// volumes that are not there, or would be made of other files now (Steps). Files are decoded and
/// volumes written while others are merged, in memory that does not grow with the number of steps;
/// files that no step needs are not decoded. Several processes make a part of the times each, and
/// of volumes in bricks a part of the rows of each, with the same files as one alone; the first
/// joins rows, and writes the index when all are done. All get the same report. The tasks of a run
/// make the same files one after the other, each in a process that is alone. Throws Error when
/// no input holds a ray or a file cannot be written: in all processes when it fails in one.
GridReport WriteVolumes(
  const GridJob& job, const Progress& progress = {}, const Processes& processes = Processes());

} // namespace nexrad::application
