// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Volumes/WrittenFiles.h"
#include "nexrad/Codec/NxvFile.h"
#include "nexrad/Grid/GriddedVolume.h"

#include <cstdint>
#include <filesystem>
#include <future>

namespace nexrad::application
{

/// Files that merged volumes are written to.
enum class VolumeFormat
{
  Nxv, ///< this project's compressed volumes (Documentation/Formats/nxv.md)
  Vti  ///< VTK XML image data
};

/// "20060312T180500Z.nxv".
std::filesystem::path VolumeFileName(Time time, VolumeFormat format);

/// Writes volumes into a folder, each on a thread of its own while the next one is being made. A
/// volume that was there before is not touched: see WrittenFiles.
class StepWriter
{
public:
  /// `nxv` is for VolumeFormat::Nxv.
  StepWriter(std::filesystem::path folder, VolumeFormat format, const NxvWriteOptions& nxv);
  StepWriter(const StepWriter&) = delete;
  StepWriter& operator=(const StepWriter&) = delete;

  /// Begins to write a volume when the one before is there; makes the folder before the first.
  /// Returns the volume before, whose arrays are free again. Throws Error when that could not be
  /// written.
  GriddedVolume Write(GriddedVolume volume);

  /// Waits for the last one. Throws Error when it could not be written.
  void Finish();

  /// Hands over the files; after Finish.
  WrittenFiles TakeFiles() { return std::move(files); }
  std::uintmax_t Bytes() const { return bytes; }

private:
  GriddedVolume TakeLast();

  const std::filesystem::path folder;
  const VolumeFormat format;
  const NxvWriteOptions nxv;
  WrittenFiles files;
  std::filesystem::path place;        // of the volume that is being written
  std::future<GriddedVolume> writing; // the volume comes back
  std::uintmax_t bytes = 0;
};

} // namespace nexrad::application
