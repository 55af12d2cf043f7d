// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

namespace nexrad::application
{

/// Begins to watch the resident memory of this process anew, where the system can.
void RestartPeakMemory();

/// The largest resident memory since then, or since the process began, in bytes; empty where the
/// system does not tell.
std::optional<double> PeakMemory();

} // namespace nexrad::application
