// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Drawing/Render.h"
#include "Scene/Series/VolumeSeries.h"

#include <filesystem>
#include <functional>
#include <memory>

class vtkImageData;

namespace nexrad::scene
{

/// Calls `write(path, volume)` for each time that a request asks for: a file each, with the time in
/// its name where there are several. Draws nothing, and needs no display. Throws Error when a
/// volume cannot be read or the progress says no.
RenderReport WriteEachVolume(const RenderRequest& request,
  const std::function<void(const std::filesystem::path&, vtkImageData*)>& write);

/// Opens the inputs of a request whose output is a file for each time. Files of several radars, one
/// of each and within an hour, make one file of all, unless the request names times: then the
/// request gets the middle of their times, and takes rays as far from there as the farthest is, and
/// the report gets a note.
std::unique_ptr<VolumeSeries> OpenForPictures(RenderRequest& request, RenderReport& report);

/// Adds a note where several times made several files of one name.
void SayThatThereAreSeveral(const RenderRequest& request, RenderReport& report);

} // namespace nexrad::scene
