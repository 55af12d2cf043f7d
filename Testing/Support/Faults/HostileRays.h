// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Faults/HostileFiles.h"

namespace nexrad::testing
{

/// The files of MakeHostileFiles that repeat rays.
std::vector<HostileFile> MakeHostileRays();

} // namespace nexrad::testing
