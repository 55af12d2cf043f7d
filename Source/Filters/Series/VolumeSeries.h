// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Grid/FinerBox.h"
#include "nexrad/Model/Moment.h"
#include "nexrad/Model/Time.h"
#include "nexrad/Series/VolumeSelection.h"
#include "nexrad/System/Error.h"
#include "nexrad/System/Progress.h"

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace nexrad
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

  /// The same in voxels that are large enough to be merged fast, and small enough to tell where
  /// echo is, where the series merges; else as Load.
  virtual vtkSmartPointer<vtkImageData> LoadCoarse(std::size_t index)
  {
    return this->Load(index, {});
  }

  /// A box of the domain at one of the times, in finer voxels: merged again, or read from a file
  /// that has them. Empty when `progress` asked to stop. Throws Error when it cannot be made.
  virtual vtkSmartPointer<vtkImageData> LoadBox(
    std::size_t index, const BoxRequest& box, const Progress& progress) = 0;

  /// Whether Load leaves out finer voxels that the files have: LoadBox reads them. No by default.
  virtual bool LeavesOutFiner(std::size_t) const { return false; }

  /// Whether Load may give codes in place of values (vtkNexradImageConversion.h), which are read
  /// and uploaded faster. No by default; a series that knows no codes takes no notice. True when
  /// Load gives other volumes than before. May be asked while another thread loads.
  virtual bool AllowCodes(bool) { return false; }

  /// What the volume of a time is made of, as text: where it is the same in two series, their
  /// volumes are. Empty where that is not known.
  virtual std::string Contents(std::size_t) const { return {}; }

  /// The moments that the inputs hold, as far as they are known; not only those that Load gives.
  virtual std::vector<MomentName> Moments() const { return {}; }

  /// Whether Load gives ancillary arrays (age, number of radars, weight, nearest radar) where they
  /// are asked for.
  virtual bool MakesAncillaryArrays() const { return false; }

  /// Of several radars with one file each, the time from their first to their last ray: such files
  /// are one look at the echo rather than a series. Else nothing.
  virtual std::optional<TimeSpan> OneLook() const { return std::nullopt; }

  /// Inputs that were damaged or left out so far, a line each.
  virtual std::vector<std::string> Problems() const { return {}; }
};

} // namespace nexrad
