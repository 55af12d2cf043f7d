// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Scene/Series/VolumeSeries.h"

#include <memory>

class vtkNexradDayReader;

namespace nexrad::scene
{

/// The volumes at the time steps of a day reader, which is not changed otherwise while they are in
/// use. Throws Error for what the reader reports as an error.
std::unique_ptr<VolumeSeries> OpenDayVolumes(vtkNexradDayReader* reader);

} // namespace nexrad::scene
