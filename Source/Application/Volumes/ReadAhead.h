// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "VolumeSeries.h"

namespace nexrad::application
{

/// The same series, of which the volume after the one loaded last (after the last the first) is
/// loaded ahead on another thread, so that a series that plays on waits for nothing. One volume is
/// held ahead, no more. A series that cannot be loaded ahead comes back as it is.
std::unique_ptr<VolumeSeries> ReadAhead(std::unique_ptr<VolumeSeries> series);

} // namespace nexrad::application
