// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Level2/Level2File.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace nexrad::application
{

/// A file of the output, and how much is said of it.
struct InputSubject
{
  std::string file;
  bool ofFolder = false; ///< one of many: a line in the table
};

/// Each argument, with the radar files in it in place of a folder that is none of chunks, or of a
/// tar archive. What is wrong with a folder is said, and the folder stays as what cannot be read.
/// `leftOut` becomes true for a file in a folder that is no radar file.
std::vector<InputSubject> FindSubjects(const std::vector<std::string>& arguments, bool& leftOut);

/// Reads files (or folders of chunks) one after the other: every ray that can be read. The damage
/// is written to standard error, a line each. What cannot be read at all comes back as a volume
/// without sweeps whose damage is the reason, so that each file has its place in the output.
class ExplainedReader
{
public:
  /// `subjects` must outlive this object.
  explicit ExplainedReader(
    const std::vector<InputSubject>& subjects, const Level2Options& options = {});

  /// The volume of the next subject. Where it has no end, the subject behind it is read, too: that
  /// tells whether the radar broke the volume off (EndWithNext).
  RadarVolume Next();

private:
  struct Reading
  {
    RadarVolume volume;
    bool failed = false; ///< its damage is the error, which names the file
  };

  Reading Read(std::size_t index) const;

  const std::vector<InputSubject>& subjects;
  Level2Options options;
  std::size_t index = 0;
  std::optional<Reading> ahead; ///< of the next subject, where it was read before
};

} // namespace nexrad::application
