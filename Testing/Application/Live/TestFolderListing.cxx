// SPDX-License-Identifier: BSD-3-Clause
#include "Live/FolderListing.h"

#include "TestData.h"

#include <gtest/gtest.h>

#include <sys/stat.h>

#include <fstream>
#include <string>
#include <vector>

using namespace nexrad::application;
using namespace nexrad::testing;
namespace fs = std::filesystem;

namespace
{

class FolderListings : public ::testing::Test
{
protected:
  void Write(const std::string& name, const std::string& text) const
  {
    const fs::path path = folder.Path() / name;
    fs::create_directories(path.parent_path());
    std::ofstream(path, std::ios::binary) << text;
  }

  std::vector<std::string> Poll()
  {
    std::vector<std::string> names;
    for (const ArrivedFile& file : listing.Poll())
    {
      names.push_back(fs::relative(file.path, folder.Path()).string());
    }
    return names;
  }

  const TemporaryFolder folder;
  FolderListing listing{{folder.Path()}};
};

using Names = std::vector<std::string>;

} // namespace

TEST_F(FolderListings, NameWhatCameAndWhatChangedOnce)
{
  EXPECT_EQ(this->Poll(), Names());
  this->Write("KEAX/1/a", "one");
  this->Write("b", "two");
  EXPECT_EQ(this->Poll(), (Names{"b", "KEAX/1/a"}));
  EXPECT_EQ(this->Poll(), Names());
  this->Write("b", "twofold");
  EXPECT_EQ(this->Poll(), Names{"b"}) << "it grew";
  fs::remove(folder.Path() / "b");
  EXPECT_EQ(this->Poll(), Names());
  this->Write("b", "two");
  EXPECT_EQ(this->Poll(), Names{"b"});
  fs::remove_all(folder.Path() / "KEAX");
  EXPECT_EQ(this->Poll(), Names());
  this->Write("KEAX/1/a", "one");
  EXPECT_EQ(this->Poll(), Names{"KEAX/1/a"}) << "the number of a volume came again";
}

TEST_F(FolderListings, PassOverHiddenNamesUntilTheyAreRenamed)
{
  this->Write(".a", "one");
  this->Write(".watch/state.json", "{}");
  EXPECT_EQ(this->Poll(), Names());
  fs::rename(folder.Path() / ".a", folder.Path() / "a");
  EXPECT_EQ(this->Poll(), Names{"a"});
}

TEST_F(FolderListings, LookAgainAtAFileThatIsWatched)
{
  this->Write("a", "one");
  const auto old = fs::file_time_type::clock::now() - std::chrono::hours(1);
  fs::last_write_time(folder.Path() / "a", old);
  fs::last_write_time(folder.Path(), old);
  EXPECT_EQ(this->Poll(), Names{"a"});
  listing.Watch(folder.Path() / "a", true);
  this->Write("a", "one and more"); // does not change the time of the folder
  fs::last_write_time(folder.Path(), old);
  EXPECT_EQ(this->Poll(), Names{"a"});
}

TEST_F(FolderListings, AreNotHeldUpByLinksAndPipes)
{
  this->Write("inner/a", "one");
  fs::create_directory_symlink(folder.Path(), folder.Path() / "inner" / "back");
  ASSERT_EQ(mkfifo((folder.Path() / "pipe").c_str(), 0600), 0);
  EXPECT_EQ(this->Poll(), Names{"inner/a"});
  const auto problems = listing.TakeProblems();
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_NE(problems[0].find("pipe: neither a file nor a folder"), std::string::npos);
  this->Poll();
  EXPECT_TRUE(listing.TakeProblems().empty());
}

TEST(FolderListing, WaitsForAFolderThatDoesNotExist)
{
  const TemporaryFolder folder;
  FolderListing listing({folder.Path() / "later"});
  EXPECT_TRUE(listing.Poll().empty());
  ASSERT_EQ(listing.TakeProblems().size(), 1U);
  fs::create_directory(folder.Path() / "later");
  std::ofstream(folder.Path() / "later" / "a") << "one";
  EXPECT_EQ(listing.Poll().size(), 1U);
  EXPECT_TRUE(listing.TakeProblems().empty());
}
