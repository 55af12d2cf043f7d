// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

namespace nexrad::application
{

/// A new empty folder among the system's temporary files (TMPDIR), removed with all that is in it
/// when this ends.
class WorkFolder
{
public:
  /// Throws Error when it cannot be made.
  WorkFolder();
  ~WorkFolder();
  WorkFolder(const WorkFolder&) = delete;
  WorkFolder& operator=(const WorkFolder&) = delete;

  const std::filesystem::path& Path() const { return path; }

private:
  std::filesystem::path path;
};

} // namespace nexrad::application
