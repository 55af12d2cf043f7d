// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Sheets/Sheet.h"

namespace nexrad::scene
{

/// The same time merged into volumes of several sizes (the thesis's figure 4.3), and the difference
/// of each picture from that of the last, the finest.
Sheet DrawResolutionSheet(const SheetSource& source);

} // namespace nexrad::scene
