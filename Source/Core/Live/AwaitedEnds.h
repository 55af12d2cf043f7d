// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Series/ScannedFile.h"

#include <map>
#include <set>
#include <string>
#include <vector>

namespace nexrad
{

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

  /// Keeps what a file says of its volumes, in place of what it said before. The problem of a
  /// missing end goes from the file to this object.
  void Keep(ScannedFile& file);

  /// What is known by now. Of the radars that are `silent` no next volume is expected any more.
  Decided TakeDecided(const std::set<std::string>& silent);

private:
  struct Awaited
  {
    std::string radar;
    SeriesVolume volume;
    InputProblem problem;
  };

  const SeriesVolume* FindNext(const Awaited& before) const;
  void Forget();

  std::vector<Awaited> awaited;
  std::map<std::string, std::vector<SeriesVolume>> volumes; ///< by radar, of those that may follow
};

} // namespace nexrad
