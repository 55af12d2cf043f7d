// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Sheets/Sheet.h"

namespace nexrad::scene
{

/// One volume by 16 to 1024 slices (the thesis's figure 4.4), and the difference of each picture
/// from that of 2048 slices.
Sheet DrawSlicesSheet(const SheetSource& source);

} // namespace nexrad::scene
