// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>

namespace nexrad::application
{

/// Writes bytes to a new file, or in place of an old one, in one step. A path that is a device or a
/// pipe is written to directly. Throws Error, naming the file and the reason, when not all bytes
/// arrived.
void WriteFile(const std::filesystem::path& path, const unsigned char* bytes, std::size_t size);

/// Makes a folder and those above it. Throws Error when that fails.
void MakeFolder(const std::filesystem::path& path);

} // namespace nexrad::application
