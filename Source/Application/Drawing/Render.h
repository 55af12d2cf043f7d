// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Requests/RenderRequest.h"

namespace nexrad::scene
{

/// Draws the pictures or the movie. Throws Error when that cannot be done.
RenderReport Render(const RenderRequest& request);

} // namespace nexrad::scene
