// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Requests/RenderRequest.h"
#include "Requests/ViewRequest.h"
#include "Requests/WebRequest.h"

namespace nexrad::application
{

/// Loads the library that draws, which brings VTK's rendering with it, and has it do the request.
/// Throws Error when the library is not where the program was built or installed, and for what the
/// drawing itself fails at.
scene::RenderReport RenderWithLibrary(const scene::RenderRequest& request);
scene::WebReport WebWithLibrary(const scene::WebRequest& request);

/// Shows a window with menus, time line and panels until the user closes it. Throws Error when the
/// program was built without Qt, too.
scene::ViewReport WindowWithLibrary(const scene::ViewRequest& request);

} // namespace nexrad::application
