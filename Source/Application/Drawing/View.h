// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Requests/ViewRequest.h"

namespace nexrad::scene
{

/// Shows a window until the user closes it. Throws Error when that cannot be done.
ViewReport View(const ViewRequest& request);

} // namespace nexrad::scene
