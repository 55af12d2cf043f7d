// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Volumes/StepWriter.h"

#include <string>
#include <vector>

namespace nexrad::application
{

/// Names of the files that a run makes in its folder: for each time one of all radars, or one of
/// each radar; and what has all times, which is an index or one file.
class RunFiles
{
public:
  /// `radars`: names of those that get files of their own; empty: one for all of them. `oneFile`:
  /// all times in one file.
  RunFiles(VolumeFormat format, const std::vector<std::string>& radars, bool oneFile);

  /// "20060312T180500Z.nxv", or "KEAX_20060312T180500Z.nxv" of each radar.
  std::vector<std::string> At(Time time) const;

  /// The files of one radar, or of all.
  struct Series
  {
    /// "volumes.nxv.series", "KEAX.nxv.series"; of one file "volumes.nc", "KEAX.nc".
    std::string name;
    std::vector<std::string> files; ///< one for each time
  };
  std::vector<Series> SeriesOf(const std::vector<Time>& times) const;

private:
  VolumeFormat format;
  std::vector<std::string> radars; ///< "" for all of them
  bool oneFile;
};

} // namespace nexrad::application
