// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Output/InputSubjects.h"
#include "nexrad/Level2/Level2File.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace nexrad::application
{

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
