// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Level2/Level2File.h"
#include "nexrad/Model/RadarVolume.h"
#include "nexrad/Moments/MomentMaker.h"
#include "nexrad/Polar/PolarVolume.h"
#include "nexrad/Series/Catalogue.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace nexrad
{

/// What a scan makes of the files; as MomentOptions, how it makes the volumes that visitors get and
/// that summaries are made of.
struct SeriesOptions : MomentOptions
{
  Level2Options level2;
  std::vector<MomentName> moments; ///< a volume without any of them is left out; empty: none is
  bool requirePosition = false;    ///< a volume of a site without a position is left out
  bool lowEchoes = false;          ///< make SeriesVolume::lowEcho where REF is among the moments
  bool summaries = false; ///< make the summaries of the volumes, of the moments, one at least
  unsigned threads = 0;   ///< that decode files; 0: as many as there are cores
};

/// Called for each volume while its data are in memory, once for each moment of the options that it
/// has, from several threads at once. The last is that moment as MomentMaker makes it, nullptr
/// without a moment in the options.
using VolumeVisitor = std::function<void(
  const SeriesVolume&, const RadarVolume&, const std::shared_ptr<const PolarVolume>&)>;

/// A file as it is stored now, as text: its path, size and time of change.
std::string OriginOf(const std::filesystem::path& path);

/// What one input file holds.
struct ScannedFile
{
  std::string origin; ///< OriginOf the file before it was read; empty: nobody knows what it holds
  std::vector<std::pair<Site, SeriesVolume>> volumes;
  std::vector<InputProblem> problems;
  std::vector<std::string> notes; ///< what the merge leaves out, or lacks, although nothing is
                                  ///< wrong with it, a line each, with the file
};

/// True of what stands for a file of which nothing is known.
inline bool IsUnknown(const ScannedFile& file)
{
  return file.origin.empty();
}

/// Whether quality control said of some volume of a file what it found.
bool TellsEcho(const ScannedFile& file);

/// Decodes one file and says what it holds; what is wrong goes to the problems.
ScannedFile ScanFile(
  const std::filesystem::path& path, const SeriesOptions& options, const VolumeVisitor& visitor);

/// The same of a file that was decoded before, or of a part of it; `path` names it.
ScannedFile ScanVolume(const RadarVolume& whole, const std::filesystem::path& path,
  const SeriesOptions& options, const VolumeVisitor& visitor);

/// Says that two radars of one name stand at two places (StandApart): where `site` stands, and
/// where others of its name do.
std::string DescribePlaces(const Site& site, const Site& other);

/// The note on a volume whose file lacks its end where the radar broke it off (IsBrokenOff) and
/// began `next`, of another file; else empty.
std::string DescribeRestart(const SeriesVolume& volume, const SeriesVolume& next);

/// Puts what the files hold together by sites. `problems` are those known before. A radar stands
/// where most of its volumes say; volumes of its name that stand apart from there are left out, and
/// each is a problem. That a file lacks the end of its volume is a note where DescribeRestart
/// says so.
SeriesScan CollectSeries(std::vector<InputProblem> problems, const std::vector<ScannedFile>& files);

} // namespace nexrad
