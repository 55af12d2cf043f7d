// SPDX-License-Identifier: BSD-3-Clause
#pragma once

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

/// What was made of it.
struct WebReport
{
  std::filesystem::path page;
  std::uintmax_t bytes = 0;          ///< of the page
  std::size_t times = 0;             ///< in the page, or in the index beside it
  std::vector<std::string> problems; ///< inputs that were damaged or left out, a line each
  std::vector<std::string> notes;    ///< what else is to be said, a line each
};

} // namespace nexrad::scene

namespace nexrad::application
{

/// Whether a page of that name has its volumes in it: a name that ends in .html and is not that of
/// a folder. Any other name is.
bool IsSinglePage(const std::filesystem::path& output);

/// Makes a page that draws merged volumes in a browser. Throws Error for inputs that cannot be
/// opened, and volumes that are not of one series.
scene::WebReport MakeWebPage(const scene::WebRequest& request);

} // namespace nexrad::application
