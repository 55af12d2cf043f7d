// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

namespace nexrad
{

/// Throws Error for a path that is neither a file nor a folder: a pipe keeps its reader waiting for
/// a writer, and a device never ends. To be called before a file that somebody named is opened. A
/// path that does not exist passes: opening it says what is wrong.
void RequireOrdinaryFile(const std::filesystem::path& path);

/// True for a file that can be opened without waiting: not for a folder, a pipe or a device.
bool IsOrdinaryFile(const std::filesystem::path& path);

} // namespace nexrad
