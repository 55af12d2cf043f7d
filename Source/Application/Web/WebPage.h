// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Output/MessageOutput.h"
#include "Requests/DrawingRequest.h"
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
  std::filesystem::path output; ///< a page (.html) with the volumes in it; any other name is a
                                ///< folder, for a page beside volume files
  Progress progress;
};

} // namespace nexrad::scene

namespace nexrad::application
{

/// Whether a page of that name has its volumes in it: a name that ends in .html and is not that of
/// a folder. Any other name is.
bool IsSinglePage(const std::filesystem::path& output);

/// Makes a page that draws merged volumes in a browser. The outcome names the page. Throws Error
/// for inputs that cannot be opened, and volumes that are not of one series.
Outcome MakeWebPage(const scene::WebRequest& request);

} // namespace nexrad::application
