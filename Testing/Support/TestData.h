// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <string>

namespace nexrad::testing
{

/// Folder of the real radar files, or nothing when it does not exist. The environment variable
/// NEXRAD_TEST_DATA names it, else the CMake variable of that name did.
std::optional<std::filesystem::path> TestDataFolder();

/// Whether a test without its real files fails.
bool TestDataIsRequired();

/// The file of this name in one of the folders of level2/; "" when there is none.
std::filesystem::path FindTestFile(const std::filesystem::path& data, const std::string& name);

/// Names of what a folder holds.
std::set<std::string> NamesIn(const std::filesystem::path& folder);

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

/// At the start of a test that needs real files: where they are absent, skips it, or fails when the
/// environment variable NEXRAD_REQUIRE_TEST_DATA is 1, as the test command sets it.
#define NEXRAD_REQUIRE_TEST_DATA(folder)                                                           \
  const auto folder##Found = nexrad::testing::TestDataFolder();                                    \
  if (!folder##Found)                                                                              \
  {                                                                                                \
    if (nexrad::testing::TestDataIsRequired())                                                     \
    {                                                                                              \
      FAIL() << "real radar files not found: set NEXRAD_TEST_DATA";                                \
    }                                                                                              \
    GTEST_SKIP() << "real radar files not found: set NEXRAD_TEST_DATA";                            \
  }                                                                                                \
  const std::filesystem::path& folder = *folder##Found
