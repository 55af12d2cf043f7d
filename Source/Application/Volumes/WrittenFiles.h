// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <vector>

namespace nexrad::application
{

/// Files that a run writes. What was there before stays as it is until the run has succeeded: a
/// file that would take the place of one is written beside it under a hidden name, and renamed by
/// Keep. Without Keep, what stands beside others is removed; files that took nobody's place stay.
class WrittenFiles
{
public:
  WrittenFiles() = default;
  ~WrittenFiles();
  WrittenFiles(WrittenFiles&& other) noexcept = default;
  WrittenFiles& operator=(WrittenFiles&& other) noexcept;
  WrittenFiles(const WrittenFiles&) = delete;
  WrittenFiles& operator=(const WrittenFiles&) = delete;

  /// The path to write a file to that will be named `path`: beside a file that is there. (What else
  /// may be there, as a folder, is for the writing to refuse.)
  static std::filesystem::path PlaceFor(const std::filesystem::path& path);

  /// The file is there, or will be, at the place for `path`.
  void Add(const std::filesystem::path& written, const std::filesystem::path& path);

  /// Gives all files their names. Throws Error when one cannot be renamed.
  void Keep();

  /// Removes all files that were written.
  void Remove();

  bool IsEmpty() const { return files.empty(); }

private:
  struct File
  {
    std::filesystem::path written;
    std::filesystem::path path;
  };
  void RemoveBeside();

  std::vector<File> files;
};

} // namespace nexrad::application
