// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Sheets/SheetRequest.h"

namespace nexrad::scene
{

/// Draws the sheets. Throws Error when there is no display, or no file can be merged.
SheetReport DrawSheets(const SheetRequest& request);

} // namespace nexrad::scene
