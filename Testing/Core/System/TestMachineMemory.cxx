// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/System/MachineMemory.h"

#include "TestData.h"

#include <gtest/gtest.h>

#include <unistd.h>

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

using namespace nexrad;
using nexrad::testing::TemporaryFolder;
namespace fs = std::filesystem;

namespace
{

void Write(const fs::path& path, const std::string& text)
{
  fs::create_directories(path.parent_path());
  std::ofstream(path) << text << '\n';
}

#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
constexpr bool allocatorIsOfGlibc = true;
#else
constexpr bool allocatorIsOfGlibc = false; // the sanitisers have their own
#endif

// Bytes that the process has in memory.
std::size_t ResidentBytes()
{
  std::size_t all = 0;
  std::size_t resident = 0;
  std::ifstream("/proc/self/statm") >> all >> resident;
  return resident * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

} // namespace

TEST(MachineMemory, IsWhatTheMachineHasOrLess)
{
  const auto memory = MachineMemory();
  ASSERT_TRUE(memory);
  EXPECT_GT(*memory, std::size_t(64) << 20);
  EXPECT_LT(*memory, std::size_t(1) << 50);
}

TEST(MachineMemory, TheLeastLimitOfTheGroupsAboveCounts)
{
  const TemporaryFolder folder;
  const fs::path& root = folder.Path();
  Write(root / "outer" / "memory.max", "2147483648");
  Write(root / "outer" / "inner" / "memory.max", "max");
  EXPECT_EQ(ControlGroupMemory("0::/outer/inner\n", root), std::size_t(2) << 30);
  Write(root / "outer" / "inner" / "memory.max", "1073741824");
  EXPECT_EQ(ControlGroupMemory("0::/outer/inner\n", root), std::size_t(1) << 30);
  EXPECT_EQ(ControlGroupMemory("0::/outer\n", root), std::size_t(2) << 30);
  // In a container the group of the process is the root.
  EXPECT_EQ(ControlGroupMemory("0::/\n", root), std::nullopt);
  Write(root / "memory.max", "536870912");
  EXPECT_EQ(ControlGroupMemory("0::/\n", root), std::size_t(1) << 29);
}

TEST(MachineMemory, GroupsOfVersion1AreKnown)
{
  const TemporaryFolder folder;
  Write(folder.Path() / "memory" / "group" / "memory.limit_in_bytes", "3145728");
  const std::string membership = "5:cpu,cpuacct:/other\n4:hugetlb,memory:/group\n0::/group\n";
  EXPECT_EQ(ControlGroupMemory(membership, folder.Path()), std::size_t(3) << 20);
  EXPECT_EQ(ControlGroupMemory("5:cpu:/group\nno group\n", folder.Path()), std::nullopt);
}

TEST(MachineMemory, SizesAreTextForMessages)
{
  EXPECT_EQ(MemoryText(1), "1 MiB");
  EXPECT_EQ(MemoryText(std::size_t(512) << 20), "512 MiB");
  EXPECT_EQ(MemoryText(std::size_t(5) << 29), "2.5 GiB");
}

// As after hours of volumes that came and went: between pieces in use lie freed ones.
TEST(MachineMemory, FreedPiecesBetweenOthersGoBackToTheSystem)
{
  if (!allocatorIsOfGlibc)
  {
    GTEST_SKIP() << "another allocator than that of glibc";
  }
  constexpr std::size_t pieceBytes = 60'000; // less than what the C library maps by itself
  std::vector<std::vector<char>> pieces(1'000);
  for (std::vector<char>& piece : pieces)
  {
    piece.assign(pieceBytes, 'x');
  }
  for (std::size_t i = 0; i < pieces.size(); i += 2)
  {
    std::vector<char>().swap(pieces[i]);
  }
  const std::size_t before = ResidentBytes();
  ReturnFreedMemory();
  EXPECT_LT(ResidentBytes() + pieces.size() / 2 * pieceBytes / 2, before);
  EXPECT_EQ(pieces.back().back(), 'x');
}
