// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Requests/WebRequest.h"

#include <filesystem>

namespace nexrad::application
{

/// Whether a page of that name has its volumes in it: a name that ends in .html and is not that of
/// a folder. Any other name is.
bool IsSinglePage(const std::filesystem::path& output);

/// Makes a page that draws merged volumes in a browser. Throws Error for inputs that cannot be
/// opened, and volumes that are not of one series.
scene::WebReport MakeWebPage(const scene::WebRequest& request);

} // namespace nexrad::application
