// SPDX-License-Identifier: BSD-3-Clause
#include "Output/OutputFile.h"

#include "TestData.h"
#include "nexrad/System/Error.h"

#include <gtest/gtest.h>

#include <sys/stat.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <fstream>
#include <iterator>
#include <string>
#include <thread>
#include <vector>

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

// Until somebody reads a pipe, opening it waits; a signal whose handler lets calls begin anew would
// not end that.
TEST(OutputFile, ASignalEndsTheWaitForAReader)
{
  const TemporaryFolder folder;
  const fs::path pipe = folder.Path() / "pipe.png";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  struct sigaction action = {};
  action.sa_handler = [](int) {};
  action.sa_flags = SA_RESTART;
  struct sigaction before = {};
  sigaction(SIGUSR1, &action, &before);
  std::atomic<bool> ended = false;
  std::thread sender(
    [&ended, writer = pthread_self()]
    {
      while (!ended)
      {
        pthread_kill(writer, SIGUSR1);
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
      }
    });
  EXPECT_THROW(WriteFile(pipe, bytes, sizeof(bytes)), Error);
  ended = true;
  sender.join();
  sigaction(SIGUSR1, &before, nullptr);
}

TEST(OutputFile, APipeGetsAllBytes)
{
  const TemporaryFolder folder;
  const fs::path pipe = folder.Path() / "pipe.png";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  const std::vector<unsigned char> many(300'000, 'r'); // more than a pipe holds
  std::string read;
  std::thread reader([&] { read = FileContent(pipe); });
  WriteFile(pipe, many.data(), many.size());
  reader.join();
  EXPECT_EQ(read.size(), many.size());
}
