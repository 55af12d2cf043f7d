// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Bench/BenchTable.h"
#include "Scene/Series/VolumeSeries.h"
#include "SheetRequest.h"
#include "nexrad/Series/SiteSeries.h"

#include <vtkSmartPointer.h>

#include <memory>
#include <string>
#include <vector>

class vtkImageData;

namespace nexrad::scene
{

/// A sheet and its numbers.
struct Sheet
{
  vtkSmartPointer<vtkImageData> picture;
  application::BenchTable table;
};

/// What the sheets are drawn of.
struct SheetSource
{
  const SheetRequest& request;
  SeriesScan scan;
  bool synthetic = false;
  Time time{}; ///< of all sheets but that of times

  /// The merged volumes of that size: at `time` alone, or at all steps.
  std::unique_ptr<VolumeSeries> MergeAtTime(const std::array<int, 3>& dimensions) const;
  std::unique_ptr<VolumeSeries> MergeAllSteps(const std::array<int, 3>& dimensions) const;

  /// The size of the sheets that show one.
  const std::array<int, 3>& MiddleSize() const;

  /// The title with the sites, and the word SYNTHETIC where it belongs.
  std::string Title(const std::string& what) const;
};

/// The same time merged into volumes of several sizes (the thesis's figure 4.3), and the difference
/// of each picture from that of the last, the finest.
Sheet DrawResolutionSheet(const SheetSource& source);

/// One volume by 16 to 1024 slices (the thesis's figure 4.4), and the difference of each picture
/// from that of 2048 slices.
Sheet DrawSlicesSheet(const SheetSource& source);

/// The volumes nearest to 00:10, 06:10, 18:10 and 23:10 UTC of the day, seen 20° from the vertical
/// (the thesis's figure 4.1). Of a series that does not reach over these times, four steps from the
/// first to the last.
Sheet DrawTimesSheet(const SheetSource& source);

/// The sweeps of the first radar's volume nearest to the time, as layered cones, from the side and
/// from above (the thesis's figure 3.8).
Sheet DrawSweepsSheet(const SheetSource& source);

/// The steps that DrawTimesSheet shows: indices of `times`, ascending.
std::vector<std::size_t> ChooseTimesOfDay(const std::vector<Time>& times, Duration step);

} // namespace nexrad::scene
