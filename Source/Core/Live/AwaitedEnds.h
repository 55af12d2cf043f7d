// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Series/ScannedFile.h"

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
