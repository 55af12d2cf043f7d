// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Options/DrawingOptions.h"
#include "Output/MessageOutput.h"
#include "nexrad/System/Progress.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace nexrad::scene
{

/// What the web command asks for.
struct WebRequest : DrawingRequest
{
  std::filesystem::path
    output; ///< a page (.html, .htm) with the volumes in it; any other name,
            ///< and that of a folder, is a folder for a page beside volume files
  Progress progress;
};

} // namespace nexrad::scene

namespace nexrad::application
{

/// Makes a page that draws merged volumes in a browser. The outcome names the page. Throws Error
/// for inputs that cannot be opened, and volumes that are not of one series.
Outcome MakeWebPage(const scene::WebRequest& request);

} // namespace nexrad::application
