// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>

namespace nexrad
{

/// A name for a file that is to take the place of `path` later: hidden, in the same folder, with
/// the same extension, and unlike those of all other processes and calls.
std::filesystem::path TemporaryPathFor(const std::filesystem::path& path);

/// A file that appears complete or not at all: it is written under a temporary name in the same
/// folder, and Commit gives it its name. Without Commit the temporary file is removed. Every
/// failure (no such folder, no permission, a full disk) throws Error: path, what failed, why.
class AtomicFile
{
public:
  /// Opens the temporary file. Refuses a path that is something other than a regular file (a
  /// folder, a device).
  explicit AtomicFile(const std::filesystem::path& path);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  void Write(const void* data, std::size_t size);

  /// For writers that open the file themselves, by its name, in place of Write.
  const std::filesystem::path& TemporaryPath() const { return temporary; }

  /// Makes sure that the bytes are on the disk, then renames. Nothing may be written afterwards.
  void Commit();

private:
  [[noreturn]] void Fail(const char* what) const;

  std::filesystem::path target;
  std::filesystem::path temporary;
  int descriptor = -1;
};

/// Writes a whole file through AtomicFile.
void WriteFileAtomically(const std::filesystem::path& path, const void* data, std::size_t size);

} // namespace nexrad
