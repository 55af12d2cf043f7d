// SPDX-License-Identifier: BSD-3-Clause
#include "TestData.h"

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

namespace fs = std::filesystem;

namespace nexrad::testing
{

std::optional<fs::path> TestDataFolder()
{
  const char* variable = std::getenv("NEXRAD_TEST_DATA");
  const fs::path folder = variable != nullptr ? variable : NEXRAD_TEST_DATA_DEFAULT;
  return fs::is_directory(folder / "level2") ? std::optional(folder) : std::nullopt;
}

bool TestDataIsRequired()
{
  const char* variable = std::getenv("NEXRAD_REQUIRE_TEST_DATA");
  return variable != nullptr && std::string(variable) == "1";
}

std::filesystem::path FindTestFile(const std::filesystem::path& data, const std::string& name)
{
  for (const auto& entry : std::filesystem::recursive_directory_iterator(data / "level2"))
  {
    if (entry.path().filename() == name)
    {
      return entry.path();
    }
  }
  return {};
}

std::set<std::string> NamesIn(const std::filesystem::path& folder)
{
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
  {
    names.insert(entry.path().filename().string());
  }
  return names;
}

std::string FileContent(const fs::path& path)
{
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

TemporaryFolder::TemporaryFolder()
{
  std::string pattern = (fs::temp_directory_path() / "nexrad-test-XXXXXX").string();
  if (mkdtemp(pattern.data()) == nullptr)
  {
    throw std::runtime_error("cannot make a temporary folder: " + pattern);
  }
  path = pattern;
}

TemporaryFolder::~TemporaryFolder()
{
  std::error_code ignored;
  fs::remove_all(path, ignored);
}

} // namespace nexrad::testing
