// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace nexrad
{

/// Asks the system to back memory that was not touched yet by large pages: a volume then costs a
/// page fault for each 2 MiB in place of each 4 KiB. Does nothing where the system has no such
/// call.
void UseHugePages(void* memory, std::size_t size);

} // namespace nexrad
