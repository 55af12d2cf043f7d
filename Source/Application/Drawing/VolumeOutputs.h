// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Requests/RenderRequest.h"

#include <filesystem>
#include <functional>

class vtkImageData;

namespace nexrad::scene
{

/// Calls `write(path, volume)` for each time that a request asks for: a file each, with the time in
/// its name where there are several. Draws nothing, and needs no display. Throws Error when a
/// volume cannot be read or the progress says no.
RenderReport WriteEachVolume(const RenderRequest& request,
  const std::function<void(const std::filesystem::path&, vtkImageData*)>& write);

} // namespace nexrad::scene
