// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace nexrad::testing
{

/// Folder of the real radar files, or nothing when it does not exist. The environment variable
/// NEXRAD_TEST_DATA names it, else the CMake variable of that name did.
std::optional<std::filesystem::path> TestDataFolder();

/// All bytes of a file; "" when it cannot be read.
std::string FileContent(const std::filesystem::path& path);

/// A fresh empty folder below the temporary folder, removed at the end of its life.
class TemporaryFolder
{
public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const std::filesystem::path& Path() const { return path; }

private:
  std::filesystem::path path;
};

} // namespace nexrad::testing

/// At the start of a test that needs real files: skips it, saying so, where they are absent.
#define NEXRAD_REQUIRE_TEST_DATA(folder)                                                           \
  const auto folder##Found = nexrad::testing::TestDataFolder();                                    \
  if (!folder##Found)                                                                              \
  {                                                                                                \
    GTEST_SKIP() << "real radar files not found: set NEXRAD_TEST_DATA";                            \
  }                                                                                                \
  const std::filesystem::path& folder = *folder##Found
