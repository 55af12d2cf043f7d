// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Requests/RenderRequest.h"
#include "Requests/ViewRequest.h"

namespace nexrad::application
{

/// Loads the library that draws, which brings VTK's rendering with it, and has it do the request.
/// Throws Error when the library is not where the program was built or installed, and for what the
/// drawing itself fails at.
scene::RenderReport RenderWithLibrary(const scene::RenderRequest& request);
scene::ViewReport ViewWithLibrary(const scene::ViewRequest& request);

} // namespace nexrad::application
