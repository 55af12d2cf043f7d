// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Calibration/RadarBiases.h"
#include "nexrad/Grid/FinerBox.h"
#include "nexrad/Merging/BoxFollower.h"
#include "nexrad/Merging/MemoryNeed.h"
#include "nexrad/Merging/MergeOptions.h"
#include "nexrad/Merging/TimeMerge.h"
#include "nexrad/Series/InputFiles.h"
#include "nexrad/Series/ScanInputs.h"
#include "nexrad/System/Processes.h"
#include "nexrad/System/Progress.h"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace nexrad
{

class Store;

/// Part of the time that a scan of all files takes, when volumes are merged afterwards; for a
/// progress bar.
constexpr double ScanShare = 0.3;

/// How a SeriesMerger works; it changes no volume.
struct MergerSetup
{
  RangeLoop loop;       ///< merges rows; empty: on the calling thread
  unsigned threads = 1; ///< that decode files
  /// Times are asked for in any order: volumes are kept for them in MergeOptions::memory. Else they
  /// are expected to ascend, and no volume is kept.
  bool anyOrder = false;
  Processes processes; ///< that merge the same inputs together; all call what says so
  /// Decode all files in Open, each process a part of them, so that all processes know all volumes
  /// and nothing is exchanged later. Then a block is merged from the radars that see it: the others
  /// take part in the search for motion without being decoded.
  bool scanFirst = false;
  /// Each process merges blocks of its own, of times that ascend: KnowTogether finds out what the
  /// files about a time hold, and a block is merged as where all files are scanned first.
  bool sharesBlocks = false;
  ScanOrder order = ScanOrder::ByTime; ///< of the files that processes decode for each other
  std::vector<std::string> known; ///< what KnownFiles gave elsewhere, of the same files and options
  VolumeUse use; ///< of the merged volumes, which counts for MergeOptions::memoryLimit
};

/// Merges the files of any number of radars at any times: the one way from files to merged volumes.
///
/// Which files lie about a time is taken from the times in their headers, so that the first volume
/// is there before the day is decoded; where the headers do not tell, all files are scanned first.
/// What is merged at a time, the rays decide. A header that errs may hide a volume. Whoever merges
/// a whole run calls Settle afterwards, and makes the steps again of which MadeOf then says another
/// thing. At single times, Merge scans all files as soon as a file turns out to lie elsewhere than
/// its header says; grid and time steps then stay as Open made them.
class SeriesMerger
{
public:
  /// Reads nothing yet.
  SeriesMerger(
    std::vector<std::filesystem::path> inputs, const MergeOptions& options, MergerSetup setup = {});
  ~SeriesMerger();

  /// Finds the files and the radars, the grid and the time steps. Decodes one or two files of each
  /// radar, or all files where headers do not tell enough. All processes call it. False when
  /// `progress` asked to stop. Throws Error, in all processes, when no input holds a volume that
  /// can be used, and for options that cannot be met.
  bool Open(const Progress& progress = {});

  /// The same with other options for the same files, of which the moments, how they are made
  /// (MomentOptions), whether radars are compared, the name of the site and the memory must be
  /// those of before. What was decoded stays.
  bool SetOptions(const MergeOptions& options, const Progress& progress = {});

  /// In place of Open: finds out what one of `parts` parts of the files about the time steps hold,
  /// those of neighbouring radars, so that KnownFiles tells it to other processes. `part` counts
  /// from 0. False when `progress` asked to stop. Throws Error as Open does, and where headers do
  /// not tell which files these are.
  bool KnowPart(std::size_t part, std::size_t parts, const Progress& progress = {});

  // After Open.
  const GridSpecification& Grid() const { return request.grid; }
  const std::vector<Time>& Times() const { return times; }
  /// First and last ray of all inputs, as far as headers and rays tell; whatever
  /// MergeOptions::begin and end are where MergerSetup::anyOrder is set.
  const TimeSpan& Rays() const { return rays; }
  /// Names of the radars, ascending.
  const std::vector<std::string>& Sites() const { return sites; }
  /// What was wrong in the inputs that were decoded so far, in their order.
  std::vector<InputProblem> Problems() const;
  /// What the merge leaves out of inputs in which nothing is wrong, a line each: rays that the
  /// antenna scanned beside their cut. Empty for MergeMethod::Thesis, which takes all rays.
  std::vector<std::string> Notes() const;
  /// What quality control found in the reflectivity of the volumes that were decoded so far, gates
  /// by reason; empty where it is off or no reflectivity was made. All processes call it, and all
  /// get the same.
  std::optional<ReasonCounts> Echo() const;
  /// The moments that some volume has, of those that were decoded so far.
  std::vector<MomentName> Moments() const;
  /// What the comparison of the radars found (Formulas Q6) in the volumes that the time steps take,
  /// as far as all processes knew them in Settle; after a scan, in all volumes. Empty unless
  /// MergeOptions asked for it and there are several radars.
  BiasReport CompareRadars() const;
  /// The biases that are taken off reflectivity: those given, or those found.
  const RadarBiases& BiasesTakenOff() const { return request.beam.biases; }
  /// The input files and chunk folders.
  const std::vector<std::filesystem::path>& Files() const { return found.paths; }
  /// True when all files were decoded to learn what they hold.
  bool IsScanned() const { return scan.has_value(); }
  /// How many times a file was decoded for a volume.
  std::size_t DecodedFiles() const;

  /// The last time that will be asked for, before the first is.
  void EndAt(Time time);

  /// The merged volume at a time, or a block of it, with all moments. Each of them is what a merge
  /// of it alone makes on this grid. The arrays of `memory` are used again. Empty when `progress`
  /// asked to stop. Throws Error when it cannot be made.
  std::optional<GriddedVolume> Merge(Time time, const Progress& progress = {},
    const std::optional<VoxelBlock>& block = {}, GriddedVolume memory = {});

  /// The same as Merge gives, in bands of rows (PlannedMerge). False when `progress` asked to stop.
  /// Throws Error as Merge does.
  bool MergeInBands(Time time, int rows, const TakeBand& take, const Progress& progress = {},
    const std::optional<VoxelBlock>& block = {});

  /// The volume of each radar alone at a time, in the order of Sites, given to `take`: what a merge
  /// of its files alone makes on this grid. A radar without any in reach has a volume in which no
  /// voxel is scanned. Files are decoded once for all of them. False when `progress` asked to stop.
  /// Throws Error as Merge does.
  bool MergeEachRadar(
    Time time, const std::function<void(GriddedVolume)>& take, const Progress& progress = {});

  /// Finds out what the files about a time hold. Files are decoded only where nobody knows it yet
  /// (see LearnFiles). False when `progress` asked to stop.
  bool Know(Time time, const Progress& progress = {});
  /// The same in all processes, each of which decodes a part of the files and tells the others. All
  /// of them call it.
  bool KnowTogether(Time time, const Progress& progress = {});
  /// All that decides what Merge makes of the files at a time, beside the options, as text: grid,
  /// biases and volumes, by what is known of the files.
  std::string MadeOf(Time time) const;
  /// The same by what was known when the volumes of a time were last taken for a merge.
  std::string LastMadeOf(Time time) const;
  /// Whether some time step takes a volume, by what is known of the files.
  bool TakesVolumes() const;

  /// What is known of the files and was not told by a call before, as bytes.
  std::string KnownFiles();
  /// Takes what KnownFiles gave with the same options, of the files that are still as they were.
  /// Throws Error when it cannot be read.
  void LearnFiles(const std::string& text);

  /// A box of the domain at a time, in voxels of its own, from the volumes that Merge takes at that
  /// time; what was decoded and made ready for Merge is used, and the next Merge finds it as it
  /// was. The radars' geometry is kept as long as the voxels stay where they are. A box that
  /// follows its echo (BoxRequest::followedFrom, with MergerSetup::anyOrder) needs the reflectivity
  /// of all volumes between that time and this one; those that were not decoded before are decoded
  /// for it. Empty when `progress` asked to stop. Throws Error as Merge and MakeFinerBox do, and
  /// for the method "thesis", whose voxels are not those of a beam.
  std::optional<GriddedVolume> MergeBox(
    Time time, const BoxRequest& box, const Progress& progress = {});

  /// Takes up what all processes know of the files by now: MadeOf and Merge go by it. False when
  /// grid or time steps are then others: after Scan all has to be made anew. All processes call it.
  bool Settle();

  /// Decodes all files to learn what they hold; from then on nothing depends on headers. All
  /// processes call it. False when `progress` asked to stop. Throws Error as Open does.
  bool Scan(const Progress& progress = {});

private:
  bool Begin(const Progress& progress);
  void FindFiles();
  bool BeginByHeaders();
  bool OpenByHeaders();
  std::vector<std::size_t> EndFiles() const;
  std::vector<std::size_t> FilesByHeaders() const;
  std::optional<TimeSpan> FindEnds();
  bool NeedsLastRay() const;
  bool KnowTogether(const std::vector<std::size_t>& indices, const Progress& progress);
  bool HasSeveralRadars() const;
  SeriesOptions ScanOptions() const;
  void Plan(const SeriesScan& decoded, const TimeSpan& ends);
  bool ScanFiles(const Progress& progress);
  void PlanByScan();
  void BeginStore();
  void PlanRequest(bool hasGrid);
  SeriesScan KnownScan() const;
  std::vector<ScannedFile> Gather() const;
  std::vector<bool> FindReaching(
    const Catalogue& catalogue, const std::vector<ChosenVolume>& chosen);
  void AddSweepless(
    const Catalogue& catalogue, const ChosenVolume& chosen, std::vector<ReadyVolume>& volumes);
  std::optional<std::vector<ReadyVolume>> VolumesOf(
    Time time, const std::optional<VoxelBlock>& block, const Progress& progress);
  std::optional<std::vector<ReadyVolume>> VolumesAbout(
    Time time, const std::vector<bool>& reaching, const Progress& progress);
  std::optional<BeamVolumes> EchoAbout(Time time, const Progress& progress);
  SeriesMerger* MergerOfEcho(const Progress& progress);
  std::optional<std::array<double, 2>> WayOf(
    const BoxRequest& box, Time time, const Progress& progress);

  const std::vector<std::filesystem::path> inputs;
  const MergerSetup setup;
  MergeOptions options;
  MergeRequest request;
  InputFiles found;
  InputSizes sizes;                           ///< of the files that were found
  std::size_t memoryForRays = 0;              ///< that are kept for other times
  std::optional<FilesByRadar> headers;        ///< of the files; empty when they do not tell
  std::map<std::string, std::size_t> origins; ///< of the files; empty until LearnFiles needs them
  std::set<std::string> told;     ///< origins of the files that KnownFiles told, or LearnFiles
  std::optional<SeriesScan> scan; ///< of all files
  std::shared_ptr<const MergeRequest> planned; ///< by which volumes are made ready
  std::unique_ptr<Store> store;
  MergeRun run;
  MergeRun boxRun;                          ///< of MergeBox
  std::shared_ptr<BoxFollower> follower;    ///< of the boxes, until the volumes or the grid change
  std::unique_ptr<SeriesMerger> echoMerger; ///< of reflectivity, where it is not merged here
  std::vector<Time> times;
  TimeSpan rays; ///< of all inputs
  std::vector<std::string> sites;
  std::vector<Position> positions; ///< of `sites`
  std::vector<MergeRun> radarRuns; ///< of MergeEachRadar, one for each of `sites`
};

} // namespace nexrad
