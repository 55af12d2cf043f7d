// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Requests/ViewRequest.h"

namespace nexrad::viewer
{

/// Shows the window until the user closes it. Throws Error when there is no display.
scene::ViewReport RunWindow(const scene::ViewRequest& request);

} // namespace nexrad::viewer
