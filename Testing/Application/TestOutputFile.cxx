// SPDX-License-Identifier: BSD-3-Clause
#include "Output/OutputFile.h"

#include "TestData.h"
#include "nexrad/System/Error.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>

namespace fs = std::filesystem;
using namespace nexrad;
using namespace nexrad::application;
using nexrad::testing::FileContent;
using nexrad::testing::TemporaryFolder;

namespace
{

const unsigned char bytes[] = {'r', 'a', 'd', 'a', 'r'};

std::ptrdiff_t EntriesOf(const fs::path& folder)
{
  return std::distance(fs::directory_iterator(folder), fs::directory_iterator());
}

} // namespace

TEST(OutputFile, WritesInPlaceOfAnOldFile)
{
  const TemporaryFolder folder;
  const fs::path path = folder.Path() / "file.png";
  std::ofstream(path) << "something longer than the new content";
  WriteFile(path, bytes, sizeof(bytes));
  EXPECT_EQ(FileContent(path), "radar");
  EXPECT_EQ(EntriesOf(folder.Path()), 1);
}

TEST(OutputFile, AFullDiskIsAnError)
{
  EXPECT_THROW(WriteFile("/dev/full", bytes, sizeof(bytes)), Error);
}

TEST(OutputFile, AMissingFolderIsAnError)
{
  const TemporaryFolder folder;
  EXPECT_THROW(WriteFile(folder.Path() / "none" / "file.png", bytes, sizeof(bytes)), Error);
}

TEST(OutputFile, AFolderIsMadeWithThoseAboveIt)
{
  const TemporaryFolder folder;
  MakeFolder(folder.Path() / "a" / "b");
  EXPECT_TRUE(fs::is_directory(folder.Path() / "a" / "b"));
  MakeFolder(folder.Path() / "a" / "b");
  std::ofstream(folder.Path() / "file") << "x";
  EXPECT_THROW(MakeFolder(folder.Path() / "file"), Error);
  EXPECT_THROW(MakeFolder(folder.Path() / "file" / "below"), Error);
}
