// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Grid/GriddedVolume.h"
#include "nexrad/Merging/MemoryNeed.h"
#include "nexrad/Merging/TimeMerge.h"
#include "nexrad/Series/ScannedFile.h"
#include "nexrad/System/Progress.h"
#include "nexrad/System/RangeLoop.h"

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace nexrad
{

/// What one file, or the folder of the chunks of one volume, holds now.
struct LiveInput
{
  std::string key;            ///< tells it from all others
  std::filesystem::path path; ///< named in problems
  RadarVolume volume;
  bool finished = false; ///< nothing more is expected of it
};

/// What becomes of merged volumes while others arrive: one at a time is merged and written, of nine
/// bytes a voxel at most beside those of its values.
constexpr VolumeUse LiveUse = {0, 9};

/// The newest volumes of any number of radars, made ready for merges, while they arrive. A volume
/// that grows replaces what was there of it; the others stay as they were made. Once all volumes
/// about a time are finished, Merge makes what SeriesMerger makes of the same files at that time.
class LiveSeries
{
public:
  /// `loop` prepares volumes and runs the rows of merges. Throws Error for moments that the method
  /// does not know, and when biases shall be measured (MergeOptions::measureBiases), for which all
  /// volumes would have to be known; and, as later for the first volume of each radar, for a grid
  /// that needs more memory than MergeOptions::memoryLimit.
  LiveSeries(const MergeOptions& options, const RangeLoop& loop, const VolumeUse& use = LiveUse);

  /// Takes inputs in place of those with the same keys. Returns what each of them holds, in their
  /// order; a volume that cannot be used is among the problems there, as one of a further radar
  /// for which there is no memory. As long as the domain may change, a radar whose last volume
  /// is taken out, by an input without rays, has no part in it.
  std::vector<ScannedFile> Put(const std::vector<LiveInput>& inputs);
  /// The domain stays as it is now, whatever radars come.
  void KeepGrid() { keepsGrid = true; }
  /// A radar that is known from an earlier run, before its first volume comes; `range` in m as
  /// RangeOf. As long as the domain may change, the range of a radar is that of its first volume.
  void Expect(const Site& site, double range);

  /// Drops finished volumes that no time from `from` on needs.
  void Forget(Time from);

  /// True as soon as a radar is known.
  bool HasGrid() const { return !sites.empty(); }
  const GridSpecification& Grid() const { return request.grid; }
  /// The radars that made the domain, by name, with their own ranges, m.
  const std::map<std::string, std::pair<Site, double>>& Sites() const { return sites; }
  /// The volumes that are held.
  const Catalogue& Known() const { return known; }
  /// Last ray of the held volumes of each radar.
  std::map<std::string, Time> NewestByRadar() const;
  /// Bytes that the prepared volumes take.
  std::size_t MemoryBytes() const;

  /// All that decides what the volume merged at a time contains, beside the options: the domain,
  /// and what Catalogue::MadeOf says.
  std::string InputsAt(Time time) const;
  /// True when all volumes that take part at a time are finished, and each radar but those that are
  /// `silent` has a finished volume that begins later.
  bool IsSettled(Time time, const std::set<std::string>& silent) const;

  /// The merged volume at a time, with all moments. The arrays of `memory` are used again. Empty
  /// when `progress` asked to stop.
  std::optional<GriddedVolume> Merge(
    Time time, const Progress& progress = {}, GriddedVolume memory = {});
  /// The same merge, to be made in parts. It serves as long as the domain stays.
  PlannedMerge Plan(Time time);
  /// What has become of a merge by the volumes that arrived since it was planned.
  PlannedMerge PlanAgain(const PlannedMerge& before);

private:
  struct Volume
  {
    Site site;
    SeriesVolume description;       ///< its input is the place in `held`
    std::vector<ReadyVolume> ready; ///< each moment that it has
    bool finished = false;
  };

  void List();
  std::vector<ChosenVolume> ChosenAt(Time time) const;
  std::vector<ReadyVolume> VolumesFor(Time time);
  void PlanGrid();
  void LeaveOutOthers(std::vector<ScannedFile>& scanned) const;
  void ExpectRadarsOf(const std::vector<LiveInput>& inputs, std::vector<ScannedFile>& scanned);
  void ForgetRadar(const std::string& radar);

  const MergeOptions options;
  const SeriesOptions series;
  const VolumeUse use;
  MergeRequest request;
  MergeRun run;
  bool keepsGrid = false;
  std::map<std::string, std::pair<Site, double>> sites;
  std::map<std::string, std::vector<Volume>> volumes; ///< by key, one a cycle
  std::vector<const Volume*> held;                    ///< all of these
  Catalogue known;                                    ///< of them
};

/// Volumes that arrived without their end. The next volume of the radar tells whether the radar
/// broke one off, which is a note, or whether its end was lost, which is a problem.
class AwaitedEnds
{
public:
  struct Decided
  {
    std::vector<InputProblem> problems;
    std::vector<std::string> notes;
  };

  /// Takes the problem of a missing end from what a file says of its volumes, in place of what it
  /// said before.
  void Keep(ScannedFile& file);

  /// What the volumes that are known by now tell. Of the radars that are `silent` no next volume is
  /// expected any more.
  Decided TakeDecided(const Catalogue& known, const std::set<std::string>& silent);

private:
  struct Awaited
  {
    std::string radar;
    SeriesVolume volume;
    InputProblem problem;
  };

  std::vector<Awaited> awaited;
};

} // namespace nexrad
