// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>

namespace nexrad::application
{

/// A file under a temporary name beside its place, for what writes itself by name. Commit renames
/// it; without that the destructor removes it, so that nothing half-written stays.
class OutputFile
{
public:
  /// Throws Error when the folder of `path` does not exist.
  explicit OutputFile(const std::filesystem::path& path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// The temporary name, with the extension of the final one.
  const std::filesystem::path& TemporaryPath() const { return temporary; }

  /// Gives the file its name. Throws Error when that fails.
  void Commit();

private:
  std::filesystem::path target;
  std::filesystem::path temporary;
};

/// Writes bytes to a new file, or in place of an old one, in one step. A path that is a device or a
/// pipe is written to directly. Throws Error, naming the file and the reason, when not all bytes
/// arrived.
void WriteFile(const std::filesystem::path& path, const unsigned char* bytes, std::size_t size);

/// Makes a folder and those above it. Throws Error when that fails.
void MakeFolder(const std::filesystem::path& path);

} // namespace nexrad::application
