// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Report/BenchTable.h"
#include "Scene/Series/VolumeSeries.h"
#include "Sheets/SheetRequest.h"
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

/// Looks for what the request's files hold. Throws Error when no file can be merged, or none is
/// about the time.
SheetSource MakeSheetSource(const SheetRequest& request);

} // namespace nexrad::scene
