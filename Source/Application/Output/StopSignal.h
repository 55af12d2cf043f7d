// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace nexrad::application
{

/// From now on the first SIGINT (Ctrl+C), SIGTERM or SIGHUP (a terminal that closes) asks the
/// program to stop where it is, in order; a second one ends it at once. A SIGHUP that is ignored
/// stays so. Who waits in a call of the system has to look at IsStopAsked, or wait with poll or
/// nanosleep, which the signal ends.
void WatchStopSignals();

/// True when such a signal came.
bool IsStopAsked();

} // namespace nexrad::application
