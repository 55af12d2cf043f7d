// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Frames/DrawingTimes.h"

namespace nexrad::scene
{

/// Measures the thesis's t1, t2 and t3, the mappers in turn. The camera looks 20° from the
/// vertical, as in the thesis. Files are read again and again, so they come from the system's
/// cache. Throws Error when there is no display or a volume cannot be read.
application::DrawingReport MeasureDrawing(const application::DrawingRequest& request);

} // namespace nexrad::scene
