// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

namespace nexrad
{

/// Asks the system to back memory that was not touched yet by large pages: a volume then costs a
/// page fault for each 2 MiB in place of each 4 KiB. Does nothing where the system has no such
/// call.
void UseHugePages(void* memory, std::size_t size);

/// Bytes of memory that this process can have at most: those of the machine or, where that is less,
/// of the control group that it runs in (as a container does). Empty where the system does not
/// tell.
std::optional<std::size_t> MachineMemory();

/// The smallest limit of a control group and of those above it. `membership` is the text of
/// /proc/self/cgroup, `root` the folder that the groups are mounted in (/sys/fs/cgroup), of version
/// 1 or 2. Empty where none is limited.
std::optional<std::size_t> ControlGroupMemory(
  const std::string& membership, const std::filesystem::path& root);

/// Gives freed memory back to the system, which the C library otherwise keeps for later requests:
/// of a program that runs for days its pieces pile up between memory in use. Takes some
/// milliseconds. Does nothing with a C library that cannot.
void ReturnFreedMemory();

/// A number of bytes for a message: "512 MiB", "2.5 GiB".
std::string MemoryText(std::size_t bytes);

} // namespace nexrad
