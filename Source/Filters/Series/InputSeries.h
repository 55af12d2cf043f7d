// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Filters/Series/VolumeFiles.h"
#include "Filters/Series/VolumeSeries.h"
#include "nexrad/Grid/FinerBox.h"
#include "nexrad/Grid/GridSpecification.h"
#include "nexrad/Merging/MergeOptions.h"
#include "nexrad/System/Progress.h"

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

namespace nexrad
{

/// Merges radar files and folders of them. Throws Error when no input holds a ray, or none at the
/// times that the options name.
std::unique_ptr<VolumeSeries> OpenRadarFiles(const std::vector<std::filesystem::path>& inputs,
  const MergeOptions& options, const Progress& progress = {});

/// What a user wants to see: files, and of them which times.
struct InputRequest
{
  std::vector<std::filesystem::path> inputs; ///< volumes (.nxv, .nxv.series, .vti) or radar files
  std::optional<Time> time;                  ///< this time alone
  MergeOptions grid;                         ///< for radar files; its begin and end for both
  bool momentNamed = false;      ///< the moments of `grid` are those to read of volumes as well
  std::string colourBy;          ///< SceneOptions::colourBy
  std::optional<BoxRequest> box; ///< drawn in finer voxels
  PlaceUnit boxUnit = PlaceUnit::OfVolume;                    ///< of the faces of `box`
  std::size_t textureMemory = VolumeFileRequest::UsualMemory; ///< VolumeFileRequest::textureMemory
  bool allVoxels = false;                                     ///< VolumeFileRequest::allVoxels
  bool fewVoxels = false;                                     ///< VolumeFileRequest::fewVoxels
};

/// Opens the inputs. Throws Error when volumes and radar files are mixed, when the faces of the box
/// are in another unit than x and y of the domain, and as the two kinds do.
std::unique_ptr<VolumeSeries> OpenInputs(
  const InputRequest& request, const Progress& progress = {});

/// Indices of the volumes that the request names. Throws Error when there is none.
std::vector<std::size_t> ChooseTimes(const VolumeSeries& series, const InputRequest& request);

} // namespace nexrad
