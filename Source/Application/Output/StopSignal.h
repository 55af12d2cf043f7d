// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace nexrad::application
{

/// From now on the first SIGINT (Ctrl+C) or SIGTERM asks the program to stop where it is, in order;
/// a second one ends it at once.
void WatchStopSignals();

/// True when such a signal came.
bool IsStopAsked();

} // namespace nexrad::application
