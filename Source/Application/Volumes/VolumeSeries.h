// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Merging/MergeOptions.h"
#include "nexrad/System/Progress.h"

#include <vtkSmartPointer.h>

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

class vtkImageData;

namespace nexrad::application
{

/// Merged volumes in the order of their times, wherever they come from.
class VolumeSeries
{
public:
  virtual ~VolumeSeries() = default;

  /// Ascending; never empty.
  virtual const std::vector<Time>& Times() const = 0;

  /// The volume of one of the times. Empty when `progress` asked to stop. Throws Error when it
  /// cannot be read or made.
  virtual vtkSmartPointer<vtkImageData> Load(std::size_t index, const Progress& progress) = 0;

  /// True when Load may run on another thread while nothing else is asked of the series.
  virtual bool CanLoadAhead() const { return false; }

  /// Inputs that were damaged or left out so far, a line each.
  virtual std::vector<std::string> Problems() const { return {}; }
};

/// Merges radar files and folders of them. Throws Error when no input holds a ray, or none at the
/// times that the options name.
std::unique_ptr<VolumeSeries> OpenRadarFiles(const std::vector<std::filesystem::path>& inputs,
  const MergeOptions& options, const Progress& progress = {});

/// True when a path names merged volumes: .nxv, .nxv.series, .vti, or a folder that holds .nxv or
/// .vti files.
bool HoldsVolumes(const std::filesystem::path& path);

/// Reads merged volumes from files, from an index of a series, or from folders of them. Throws
/// Error when one of them does not exist or is none.
std::unique_ptr<VolumeSeries> OpenVolumeFiles(const std::vector<std::filesystem::path>& inputs);

} // namespace nexrad::application
