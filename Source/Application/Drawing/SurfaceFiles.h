// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Drawing/Render.h"

namespace nexrad::scene
{

/// Writes the surfaces that a request asks for as binary glTF, a file for each time. Draws nothing,
/// and needs no display. Throws Error when a volume cannot be read, or a file not be written.
RenderReport WriteSurfaces(const RenderRequest& request);

} // namespace nexrad::scene
