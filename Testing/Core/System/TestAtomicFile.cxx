// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/System/AtomicFile.h"

#include "ErrorMessage.h"
#include "TestData.h"
#include "VolumeMaker.h"
#include "nexrad/Codec/NxvFile.h"
#include "nexrad/System/Error.h"

#include <gtest/gtest.h>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <iterator>

using namespace nexrad;
using nexrad::testing::FileContent;
using nexrad::testing::MessageOf;
using nexrad::testing::TemporaryFolder;

namespace
{

namespace fs = std::filesystem;

std::size_t FilesIn(const fs::path& folder)
{
  return static_cast<std::size_t>(
    std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

// While it lives, files of this process cannot grow beyond a size: the kernel's write fails in the
// middle, as it does on a full disk.
class SmallDisk
{
public:
  explicit SmallDisk(rlim_t bytes)
    : signalBefore(std::signal(SIGXFSZ, SIG_IGN))
  {
    getrlimit(RLIMIT_FSIZE, &before);
    rlimit limit = before;
    limit.rlim_cur = bytes;
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~SmallDisk()
  {
    setrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, signalBefore);
  }
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;

private:
  rlimit before{};
  void (*signalBefore)(int);
};

} // namespace

TEST(AtomicFile, AppearsWithCommitAlone)
{
  const TemporaryFolder folder;
  {
    AtomicFile file(folder.Path() / "a");
    file.Write("one", 3);
    EXPECT_FALSE(fs::exists(folder.Path() / "a"));
    EXPECT_EQ(FilesIn(folder.Path()), 1u) << "the temporary file, beside its target";
    file.Write("two", 3);
    file.Commit();
  }
  EXPECT_EQ(FileContent(folder.Path() / "a"), "onetwo");
  EXPECT_EQ(FilesIn(folder.Path()), 1u);
}

TEST(AtomicFile, WithoutCommitNothingStaysAndTheOldFileLives)
{
  const TemporaryFolder folder;
  WriteFileAtomically(folder.Path() / "a", "old", 3);
  {
    AtomicFile file(folder.Path() / "a");
    file.Write("new", 3);
  }
  EXPECT_EQ(FileContent(folder.Path() / "a"), "old");
  EXPECT_EQ(FilesIn(folder.Path()), 1u);
}

// As writers of movies do, who choose the format by the extension.
TEST(AtomicFile, TakesWhatWritesItselfByName)
{
  const TemporaryFolder folder;
  {
    const AtomicFile file(folder.Path() / "movie.ogv");
    EXPECT_EQ(file.TemporaryPath().extension(), ".ogv");
    EXPECT_EQ(file.TemporaryPath().parent_path(), folder.Path());
    EXPECT_EQ(file.TemporaryPath().filename().string().front(), '.'); // no listing takes it
    std::ofstream(file.TemporaryPath()) << "half";
  }
  EXPECT_EQ(FilesIn(folder.Path()), 0u);
  AtomicFile file(folder.Path() / "movie.ogv");
  std::ofstream(file.TemporaryPath()) << "whole";
  file.Commit();
  EXPECT_EQ(FileContent(folder.Path() / "movie.ogv"), "whole");
  EXPECT_EQ(FilesIn(folder.Path()), 1u);
}

TEST(AtomicFile, TwoOfOneNameDoNotMeet)
{
  const TemporaryFolder folder;
  AtomicFile first(folder.Path() / "a");
  AtomicFile second(folder.Path() / "a");
  first.Write("first", 5);
  second.Write("second", 6);
  second.Commit();
  EXPECT_EQ(FileContent(folder.Path() / "a"), "second");
  first.Commit();
  EXPECT_EQ(FileContent(folder.Path() / "a"), "first");
  EXPECT_EQ(FilesIn(folder.Path()), 1u);
}

TEST(AtomicFile, AFullDiskLeavesNothing)
{
  const TemporaryFolder folder;
  const std::string content(20'000, 'x');
  const SmallDisk disk(8'192);
  EXPECT_THROW(WriteFileAtomically(folder.Path() / "a", content.data(), content.size()), Error);
  EXPECT_EQ(FilesIn(folder.Path()), 0u);
}

TEST(AtomicFile, AFullDiskLeavesTheOldVolume)
{
  const TemporaryFolder folder;
  const fs::path path = folder.Path() / "a.nxv";
  const GriddedVolume old = nexrad::testing::MakeGriddedVolume();
  WriteNxv(path, old);
  const SmallDisk disk(8'192);
  const std::string problem = MessageOf(
    [&] {
      WriteNxv(path, nexrad::testing::MakeGriddedVolume({50, 50, 20}));
    });
  EXPECT_EQ(problem, path.string() + ": cannot be written: File too large");
  EXPECT_EQ(ReadNxv(path).grid.dimensions, old.grid.dimensions);
  EXPECT_EQ(FilesIn(folder.Path()), 1u);
}

TEST(AtomicFile, RefusesFoldersAndDevices)
{
  const TemporaryFolder folder;
  EXPECT_THROW(AtomicFile(folder.Path() / "none" / "a"), Error);
  EXPECT_THROW(AtomicFile{folder.Path()}, Error);
  EXPECT_THROW(AtomicFile("/dev/full"), Error);
  EXPECT_EQ(FilesIn(folder.Path()), 0u);
}

// A process that was killed cannot remove its file; the next writer of the same path does.
TEST(AtomicFile, RemovesWhatADeadProcessLeftBehind)
{
  const TemporaryFolder folder;
  const fs::path target = folder.Path() / "movie.ogv";
  const pid_t child = fork();
  if (child == 0)
  {
    const AtomicFile left(target);
    raise(SIGKILL);
  }
  waitpid(child, nullptr, 0);
  std::ofstream(folder.Path() / ".movie.part-0123.mp4") << "of another path";
  ASSERT_EQ(FilesIn(folder.Path()), 2u);
  const AtomicFile living(target);
  EXPECT_EQ(FilesIn(folder.Path()), 2u);
  WriteFileAtomically(target, "new", 3);
  EXPECT_EQ(FileContent(target), "new");
  EXPECT_EQ(FilesIn(folder.Path()), 3u) << "what a living process writes stays";
}

TEST(AtomicFile, NamesCannotBeForeseen)
{
  const TemporaryFolder folder;
  const AtomicFile first(folder.Path() / "a");
  const AtomicFile second(folder.Path() / "a");
  EXPECT_EQ(first.TemporaryPath().filename().string().size(), std::string(".a.part-").size() + 16);
  EXPECT_NE(first.TemporaryPath(), second.TemporaryPath());
}

TEST(AtomicFile, SaysBeforehandThatThereIsNoRoom)
{
  const TemporaryFolder folder;
  const fs::path path = folder.Path() / "file";
  {
    AtomicFile file(path);
    file.Write("abc", 3);
    const SmallDisk disk(10'000);
    EXPECT_NO_THROW(file.RequireRoom(9'997));
    EXPECT_THROW(file.RequireRoom(9'998), Error);
    file.Write("def", 3);
    file.Commit();
  }
  EXPECT_EQ(FileContent(path), "abcdef");
}
